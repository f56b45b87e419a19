/** A worker that makes one animation. */

import { animationOf } from "../../files/animation.ts";
import type { AnimationOrder } from "../../files/order.ts";
import { serve } from "./worker-end.ts";

serve(({ link }: AnimationOrder, core, course) => animationOf(link, core, course));
