// Colours for canvases, read from the style sheet, which alone defines the dark, light and print schemes.
import {signal} from "@preact/signals";

type Words<Text extends string> = Text extends `${infer First} ${infer Others}` ? First | Words<Others> : Text;
const NAMES =
  "paper panel ink muted line plate rim hole faint accent good bad warn case0 case1 case2 case3 violet rose" as const;
const BANDS = "band0 band1 band2 band3 band4 band5" as const;

export type ColourName = Words<typeof NAMES | typeof BANDS>;
export type Palette = Record<ColourName, string>;

function readPalette(): Palette {
  const style = getComputedStyle(document.documentElement);
  return Object.fromEntries(
    `${NAMES} ${BANDS}`.split(" ").map((name) => [name, style.getPropertyValue(`--${name}`).trim()]),
  ) as Palette;
}

export const palette = signal<Palette>({} as Palette);

// ---- dark and light

type ColourScheme = "auto" | "light" | "dark";
const KEPT = "tubeplan.scheme";
const wantsDark = matchMedia("(prefers-color-scheme: dark)");

/** Returns the colour scheme stored in this browser. A page in a sandboxed frame may have no access to the storage. */
function keptScheme(): ColourScheme {
  try {
    return (localStorage.getItem(KEPT) as ColourScheme | null) ?? "auto";
  } catch {
    return "auto";
  }
}

export const scheme = signal<ColourScheme>("auto");

export function isDark(): boolean {
  return scheme.value === "dark" || (scheme.value === "auto" && wantsDark.matches);
}

function applyScheme(): void {
  document.documentElement.dataset.scheme = isDark() ? "dark" : "light";
  palette.value = readPalette();
}

export function chooseScheme(next: ColourScheme): void {
  scheme.value = next;
  localStorage.setItem(KEPT, next);
  applyScheme();
}

/**
 * Redraws pictures when the colours change. For printing, pictures are drawn in black on white, or in light colours,
 * and restored afterwards.
 */
export function followColours(onPaper: "print" | "light" = "print"): void {
  wantsDark.addEventListener("change", applyScheme);
  window.addEventListener("beforeprint", () => {
    document.documentElement.dataset.scheme = onPaper;
    palette.value = readPalette();
  });
  window.addEventListener("afterprint", applyScheme);
  applyScheme();
}

/** Applies the colour scheme that the user of the workbench chose. */
export function followChosenColours(): void {
  scheme.value = keptScheme();
  followColours();
}
