/** A worker that makes one animation. */

import { animationOf } from "./animation.ts";
import type { AnimationOrder } from "./order.ts";
import { serve } from "./worker-end.ts";

serve(({ link }: AnimationOrder, core, course) => animationOf(link, core, course));
