/** A worker that makes one picture. */

import { pictureOf } from "../../files/picture.ts";
import { serve } from "./worker-end.ts";

serve(pictureOf);
