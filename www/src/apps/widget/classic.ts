/**
 * The script for pages opened from disk, `<script src="river-seed.classic.js" defer>`: one file with the engine in it,
 * since browsers load neither modules nor wasm from there.
 */

import { register } from "./register.ts";

register();
