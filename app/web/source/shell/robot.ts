// Import of a robot description as a cell and an arm.
import {post} from "../server/requests";
import {cell, inform} from "../server/workbench";
import {attemptWithChoices, type Choices} from "./choice_dialog";
import type {TableText} from "./columns_dialog";
import {view} from "./page_state";
import {OPENING, openInstead} from "./project";

/** Returns true if a file is a robot description; the program reports its errors. */
export function isRobot({name, text}: TableText): boolean {
  return /\.urdf$/i.test(name) || /^\s*<[^]*<robot[\s>]/.test(text.slice(0, 65536));
}

interface ImportedRobot {
  written: string[];
  left_out: string[];
  remarks: string[];
}

/** Converts a robot description to a cell, opens it, and lists the parts that were not converted. */
export async function importRobot(robot: TableText): Promise<void> {
  const send = async (choices: Choices) => {
    const {written, left_out, remarks} = await post<ImportedRobot>("/api/arm/import", {...robot, ...choices});
    await openInstead("/api/cell/open", {file: written[0]}, written[0]);
    if (cell.value?.file === written[0]) view.value = "arm";
    const words = [...left_out.map((what) => `left out: ${what}`), ...remarks];
    if (words.length > 0) inform(`${robot.name} is imported as ${written.join(" and ")}`, words.join("; "), OPENING);
  };
  await attemptWithChoices(`${robot.name} cannot be imported`, send, OPENING);
}
