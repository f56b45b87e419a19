/** The script for `<script type="module" src=".../river-seed.js">`, which is all that a page needs. */

import { register } from "./register.ts";

register();
