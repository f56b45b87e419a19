/** The page's renderer in a worker. */

import { linked } from "../../engine/whole.ts";
import { Renderer } from "../../host/renderer.ts";
import { type Line, serve, WORK_MS } from "../../host/worker-end.ts";
import { meansOf } from "./means.ts";
import type { Answer, Init } from "./protocol.ts";

serve(
  async ({ engine }: Init, { tell, holdOn }: Line<Answer>) =>
    new Renderer(meansOf(await linked(engine), holdOn), tell, WORK_MS),
);
