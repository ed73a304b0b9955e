// Units of the columns of foreign tables: a unit chosen for one column serves the others of its dimension.
import type {ColumnChoice, ColumnsDocument} from "./columns_choice";

/** Returns the units that a quantity may have, as one text: quantities with the same units have one dimension. */
function dimensionOf({targets}: ColumnsDocument, quantity: string): string {
  return (targets.find((target) => target.quantity === quantity)?.units ?? []).join(" ");
}

/** Returns the unit that all columns of a quantity's dimension have so far; empty if there is none. */
export function unitOfOthers(document: ColumnsDocument, choices: ColumnChoice[][], quantity: string): string {
  const dimension = dimensionOf(document, quantity);
  const alike = choices.flat().filter((choice) => dimensionOf(document, choice.quantity) === dimension);
  const units = new Set(alike.map(({unit}) => unit).filter(Boolean));
  return dimension !== "" && units.size === 1 ? [...units][0] : "";
}

/**
 * Returns the choices with a unit for one column, and for the columns of the same dimension that have the same unit as
 * it had, or none either. Units that the tables state are kept.
 */
export function withUnit(
  document: ColumnsDocument,
  choices: ColumnChoice[][],
  [table, column]: readonly [number, number],
  unit: string,
): ColumnChoice[][] {
  const {quantity, unit: before} = choices[table][column],
    dimension = dimensionOf(document, quantity);
  const isStated = ({quantity: own}: ColumnChoice, t: number, c: number) =>
    document.targets.some(
      ({quantity, found}) => own === quantity && found?.table === t && found.column === c && found.unit !== "",
    );
  const follows = (choice: ColumnChoice, t: number, c: number) =>
    choice.unit === before && dimensionOf(document, choice.quantity) === dimension && !isStated(choice, t, c);
  return choices.map((row, t) =>
    row.map((choice, c) => ((t === table && c === column) || follows(choice, t, c) ? {...choice, unit} : choice)),
  );
}
