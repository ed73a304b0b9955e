// Build of the page without inlined files and inline scripts, because the page may load only its own files. With
// `--mode report`, builds the script and the style of the reports as one file each, which the program writes into every
// report.
import type {BuildOptions} from "vite";
import {defineConfig} from "vitest/config";

const SERVER = process.env.TUBEPLAN_SERVER ?? "http://127.0.0.1:8642";

const PAGE: BuildOptions = {
  target: "es2022",
  assetsInlineLimit: 0,
  modulePreload: {polyfill: false},
  emptyOutDir: true,
  chunkSizeWarningLimit: 800,
};
const REPORT: BuildOptions = {
  ...PAGE,
  outDir: "dist-report",
  copyPublicDir: false,
  cssCodeSplit: false,
  rollupOptions: {
    input: "source/report/main.tsx",
    output: {format: "iife", entryFileNames: "report.js", assetFileNames: "report[extname]"},
  },
};

export default defineConfig(({mode}) => ({
  base: "./",
  esbuild: {jsx: "automatic", jsxImportSource: "preact", ...(mode === "report" ? {charset: "ascii"} : {})},
  build: mode === "report" ? REPORT : PAGE,
  // The numeric address works even on a machine that does not resolve the name localhost.
  server: {host: "127.0.0.1", fs: {allow: ["..", "../drawing"]}, proxy: {"/api": {target: SERVER, changeOrigin: true}}},
  test: {include: ["tests/**/*.test.ts"]},
}));
