// The page's colours as the canvas needs them, read from the style sheet so that dark, light and print stay in one place.
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

/** A file that is opened in a frame of its own may ask no browser what it keeps. */
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

/** Paper is white: what is drawn for it is drawn in black on white, or in light colours, and put back afterwards. */
export function followColours(onPaper: "print" | "light" = "print"): void {
  wantsDark.addEventListener("change", applyScheme);
  window.addEventListener("beforeprint", () => {
    document.documentElement.dataset.scheme = onPaper;
    palette.value = readPalette();
  });
  window.addEventListener("afterprint", applyScheme);
  applyScheme();
}

/** The workbench's: as its user chose. */
export function followChosenColours(): void {
  scheme.value = keptScheme();
  followColours();
}
