// Functions on a sheet that only the page needs: names of holes, and movement between holes by arrow keys.
import {tubeTitle, type SheetModel} from "../../../drawing/sheet_model.js";

export type {SheetModel};

export function holeName(sheet: SheetModel, hole: number): string {
  return tubeTitle(sheet.row[hole], sheet.column[hole]);
}

/** Returns the hole next to hole `from` in the direction (du, dv) of the picture, for the arrow keys. */
export function neighbour(sheet: SheetModel, from: number, du: number, dv: number): number {
  let best = from,
    least = Infinity;
  const size = Math.hypot(du, dv);
  for (let i = 0; i < sheet.count; ++i) {
    const x = sheet.u[i] - sheet.u[from],
      y = sheet.v[i] - sheet.v[from];
    const along = (x * du + y * dv) / size;
    if (along < 0.2 * sheet.pitch) continue;
    const lateral = Math.abs(x * dv - y * du) / size;
    const cost = along + 3 * lateral;
    if (cost < least) [best, least] = [i, cost];
  }
  return best;
}
