/** The renderer of widgets in a worker. */

import { Renderer } from "../../host/renderer.ts";
import { type Line, serve, WORK_MS } from "../../host/worker-end.ts";
import { Engines } from "./engines.ts";
import { meansOf } from "./means.ts";
import type { Init } from "./protocol.ts";

serve(
  async (init: Init, { tell, coming, holdOn }: Line<Blob>) =>
    new Renderer(meansOf(await Engines.open(init, coming), holdOn), tell, WORK_MS),
);
