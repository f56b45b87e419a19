/** A worker that makes one picture. */

import { pictureOf } from "./picture.ts";
import { serve } from "./worker-end.ts";

serve(pictureOf);
