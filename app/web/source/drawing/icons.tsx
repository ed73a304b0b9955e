// Icons of the page, drawn on a grid of 20 units with a uniform line width.
const PATHS = {
  sheet: "M3 15a7.5 7.5 0 0 1 14 0zM6.5 12.6h.01M10 12.6h.01M13.5 12.6h.01M8.2 10h.01M11.8 10h.01",
  arm: "M4 17h5M6.5 17v-5l6-5 3.5 4M12.5 7l-1.4-3M6.5 12h.01",
  error: "M3 3v14h14M6 13.5l3-6 3 3.5L16.5 5",
  plan: "M4.5 15.5a1.5 1.5 0 1 0 .01 0zM15.5 3.5a1.5 1.5 0 1 0 .01 0zM6 17h6a3 3 0 0 0 0-6H8a3 3 0 0 1 0-6h6",
  calibrate: "M10 2v4M10 14v4M2 10h4M14 10h4M10 6.5a3.5 3.5 0 1 0 .01 0z",
  effects:
    "M10 3c-4 0-6.5 1-6.5 2.3S6 7.6 10 7.6s6.5-1 6.5-2.3S14 3 10 3zM3.5 5.3v9.4C3.5 16 6 17 10 17s6.5-1 6.5-2.3V5.3M3.5 10c0 1.3 2.5 2.3 6.5 2.3s6.5-1 6.5-2.3",
  outage: "M5 3h10v14H5zM7.5 7.2l1 1 1.8-2M12 7h1M7.5 11.7l1 1 1.8-2M12 11.5h1",
  undo: "M7 4L3.5 7.5 7 11M4 7.5h7.5a4.5 4.5 0 0 1 0 9H8",
  redo: "M13 4l3.5 3.5L13 11M16 7.5H8.5a4.5 4.5 0 0 0 0 9H12",
  play: "M6 4l10 6-10 6z",
  pause: "M6.5 4v12M13.5 4v12",
  back: "M14 4L6 10l8 6zM5 4v12",
  fit: "M3 7V3h4M13 3h4v4M17 13v4h-4M7 17H3v-4",
  lasso: "M4 9c0-3 3-5 6.5-5S17 6 17 9s-3 4.5-6.5 4.5c-1.6 0-3-.3-4.2-1M5.2 11.5A1.7 1.7 0 1 0 8 13c0 2-1 3.5-3 4",
  plus: "M10 4v12M4 10h12",
  minus: "M4 10h12",
  close: "M5 5l10 10M15 5L5 15",
  open: "M2.5 15.5v-11h5l1.5 2h8.5v9z",
  down: "M10 3v10M6 9.5l4 4 4-4M4 17h12",
  sun: "M10 6.5a3.5 3.5 0 1 0 .01 0zM10 1.5v2M10 16.5v2M1.5 10h2M16.5 10h2M4 4l1.4 1.4M14.6 14.6L16 16M16 4l-1.4 1.4M5.4 14.6L4 16",
  moon: "M16 11.5A6.5 6.5 0 1 1 8.5 4a5.2 5.2 0 0 0 7.5 7.5z",
  help: "M7.3 7.5a2.7 2.7 0 1 1 4 2.4c-.9.5-1.3 1-1.3 2M10 15h.01",
  chevron: "M6 8l4 4 4-4",
  print: "M6 7V3h8v4M6 14H3V7h14v7h-3M6 11.5h8V17H6z",
} as const;

export type IconName = keyof typeof PATHS;

export function Icon({name, size = 18}: {name: IconName; size?: number}) {
  const isSolid = name === "play" || name === "back";
  return (
    <svg
      class="icon"
      width={size}
      height={size}
      viewBox="0 0 20 20"
      aria-hidden="true"
      fill={isSolid ? "currentColor" : "none"}
      stroke="currentColor"
      stroke-width="1.6"
      stroke-linecap="round"
      stroke-linejoin="round"
    >
      <path d={PATHS[name]} />
    </svg>
  );
}
