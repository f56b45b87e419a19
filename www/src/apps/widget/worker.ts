/** The renderer of widgets in a worker. */

import { load } from "../../engine/make.ts";
import { Renderer } from "../../host/renderer.ts";
import { type Line, serve } from "../../host/worker-end.ts";
import { meansOf } from "./means.ts";
import type { Init } from "./protocol.ts";

serve(
  async ({ wasmUrl }: Init, { tell, coming, holdOn }: Line<Blob>) =>
    new Renderer(meansOf(await load(wasmUrl, coming), wasmUrl, holdOn), tell),
);
