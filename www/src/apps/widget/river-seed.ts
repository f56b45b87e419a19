/** `<script type="module" src=".../river-seed.js">`: all that a page needs. */

import { register } from "./register.ts";

register();
