import mdx from "@astrojs/mdx";
import { defineConfig } from "astro/config";
import riverSeed from "../river-seed-astro.mjs";

export default defineConfig({ base: "/blog", integrations: [mdx(), riverSeed()], devToolbar: { enabled: false } });
