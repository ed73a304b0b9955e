// How the page is built: no inlined files, since the page may load nothing but its own files, and no inline script.
import {defineConfig} from "vitest/config";

const SERVER = process.env.TUBEPLAN_SERVER ?? "http://127.0.0.1:8642";

export default defineConfig({
  base: "./",
  esbuild: {jsx: "automatic", jsxImportSource: "preact"},
  build: {
    target: "es2022",
    assetsInlineLimit: 0,
    modulePreload: {polyfill: false},
    emptyOutDir: true,
    chunkSizeWarningLimit: 800,
  },
  // By number: a machine need not know the name localhost.
  server: {host: "127.0.0.1", fs: {allow: ["..", "../drawing"]}, proxy: {"/api": {target: SERVER, changeOrigin: true}}},
  test: {include: ["tests/**/*.test.ts"]},
});
