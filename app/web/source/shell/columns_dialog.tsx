// Dialog for the columns of another program's table. The program proposes their meanings, the user decides, and the
// choice is remembered for tables with the same columns.
import {signal} from "@preact/signals";
import {Select, submitting, TextInput, withPoint} from "../drawing/fields";
import {choicesOf} from "../drawing/segments";
import type {Problem} from "../server/documents";
import {plural} from "../../../drawing/numbers.js";
import {asProblem, post} from "../server/requests";
import {cell, forget} from "../server/workbench";
import {
  chosenColumns,
  type ColumnChoice,
  type ColumnsDocument,
  guessed,
  missingOf,
  rememberedChoices,
  rememberChoices,
  type TableOptions,
} from "./columns_choice";
import {unitOfOthers, withUnit} from "./columns_units";
import {Dialog} from "./dialog";
import {closeDialog, dialog} from "./page_state";
import {OPENING} from "./project";
import {ProblemWords} from "./states";

export interface TableText {
  name: string;
  text: string;
}

/** Use of the tables: as readings or as a work list. */
export interface ColumnsUse {
  /** Server address that proposes the meanings of the columns. */
  address: string;
  /** True if the dialog asks for the noise of a coordinate if no column states it. */
  needsNoise: boolean;
  /** Accepts the tables with the chosen columns; the dialog shows errors thrown by this function. */
  take: (taken: TakenTables) => Promise<void>;
  /** Called after the tables are accepted. */
  then: () => Promise<void>;
}

export interface TakenTables {
  tables: TableText[];
  columns: string[];
  options: TableOptions;
  sigma?: number;
}

interface Foreign {
  use: ColumnsUse;
  tables: TableText[];
  document: ColumnsDocument;
  choices: ColumnChoice[][];
  options: TableOptions;
}

const foreign = signal<Foreign | null>(null);
const problem = signal<Problem | null>(null);
const sigma = signal("");

/** Opens the dialog if the files hold tables; otherwise throws the reason. */
export async function chooseColumns(tables: TableText[], use: ColumnsUse): Promise<void> {
  const document = await post<ColumnsDocument>(use.address, {tables});
  foreign.value = {use, tables, document, choices: rememberedChoices(document) ?? guessed(document), options: {}};
  problem.value = null;
  forget(OPENING);
  dialog.value = "columns";
}

export function ColumnsDialog() {
  const shown = foreign.value;
  return (
    <Dialog name="columns" title="Meaning of the columns">
      {shown ? <ColumnsForm shown={shown} /> : null}
    </Dialog>
  );
}

/** Changes the options of the tables, which may change the proposed meanings of their columns. */
async function changeOptions(shown: Foreign, options: TableOptions): Promise<void> {
  problem.value = null;
  foreign.value = {...shown, options};
  try {
    const body = {tables: shown.tables, ...options};
    const document = await post<ColumnsDocument>(shown.use.address, body);
    if (foreign.value?.options === options) foreign.value = {...shown, options, document, choices: guessed(document)};
  } catch (error) {
    problem.value = asProblem(error);
  }
}

/** Returns the typed noise of a coordinate, for tables in which no column states it; empty if none was typed. */
function noise({use}: Foreign): {sigma?: number} {
  return !use.needsNoise || sigma.value.trim() === "" ? {} : {sigma: Number(withPoint(sigma.value))};
}

async function take(shown: Foreign): Promise<void> {
  forget(OPENING);
  try {
    const columns = chosenColumns(shown.document, shown.choices);
    await shown.use.take({tables: shown.tables, columns, options: shown.options, ...noise(shown)});
  } catch (error) {
    problem.value = asProblem(error);
    return;
  }
  rememberChoices(shown.document, shown.choices);
  closeDialog("columns");
  await shown.use.then();
}

function ColumnsForm({shown}: {shown: Foreign}) {
  const missing = missingOf(shown.document, shown.choices);
  return (
    <form class="columns-form" onSubmit={submitting(() => take(shown))}>
      {shown.document.tables.map((_, table) => (
        <TablePreview shown={shown} table={table} />
      ))}
      <div class="row">
        {shown.document.options.map((option) => (
          <OptionChoice shown={shown} option={option} />
        ))}
      </div>
      {!shown.use.needsNoise || shown.choices.flat().some((choice) => choice.quantity === "sigma") ? null : (
        <label class="field narrow">
          one standard deviation of a coordinate ({cell.value?.units.length})
          <TextInput of={sigma} inputMode="decimal" placeholder="0.003" onEdit={() => (problem.value = null)} />
        </label>
      )}
      <p class="muted" role="status">
        {missing.length > 0 ? `Missing: ${missing.join(", ")}` : "All columns are assigned."}
      </p>
      {problem.value ? <ProblemWords problem={problem.value} /> : null}
      <div class="row">
        <button class="button first" type="submit" disabled={missing.length > 0}>
          Import
        </button>
      </div>
    </form>
  );
}

function OptionChoice({shown, option}: {shown: Foreign; option: ColumnsDocument["options"][number]}) {
  return (
    <label class="field narrow">
      {option.label}
      <Select
        choices={[{value: "", words: "as the columns state"}, ...option.values]}
        value={shown.options[option.name] ?? ""}
        onChoose={(value) => void changeOptions(shown, {...shown.options, [option.name]: value})}
      />
    </label>
  );
}

function TablePreview({shown, table}: {shown: Foreign; table: number}) {
  const {name, columns, rows, count, remarks = []} = shown.document.tables[table];
  return (
    <section>
      <h2>{name}</h2>
      <div class="columns-table">
        <table>
          <thead>
            <tr>
              {columns.map((column) => (
                <th scope="col">{column}</th>
              ))}
            </tr>
            <tr>
              {columns.map((column, k) => (
                <td>
                  <MeaningOf shown={shown} table={table} column={k} name={column} />
                </td>
              ))}
            </tr>
          </thead>
          <tbody>
            {rows.map((row) => (
              <tr>
                {row.map((field) => (
                  <td>{field}</td>
                ))}
              </tr>
            ))}
          </tbody>
        </table>
      </div>
      <p class="muted">{plural(count, "row")}</p>
      {remarks.map((remark) => (
        <p class="muted">{remark}</p>
      ))}
    </section>
  );
}

function MeaningOf({shown, table, column, name}: {shown: Foreign; table: number; column: number; name: string}) {
  const choice = shown.choices[table][column];
  const {tables, targets} = shown.document,
    none = tables[table].names === column ? "the row's name" : "nothing";
  const target = targets.find(({quantity}) => quantity === choice.quantity);
  const units = target?.units ?? [];
  const put = (choices: ColumnChoice[][]) => {
    foreign.value = {...shown, choices};
    problem.value = null;
  };
  const change = (next: Partial<ColumnChoice>) => {
    const choices = shown.choices.map((row) => [...row]);
    choices[table][column] = {...choice, ...next};
    put(choices);
  };
  return (
    <>
      <Select
        label={`what ${name} is`}
        choices={choicesOf([["", none], ...targets.map(({quantity}) => [quantity, quantity] as const)])}
        value={choice.quantity}
        onChoose={(quantity) =>
          change({quantity, unit: unitOfOthers(shown.document, shown.choices, quantity), factor: ""})
        }
      />
      {units.length > 0 ? (
        <Select
          label={`unit of ${name}`}
          choices={choicesOf([["", "unit?"], ...units.map((unit) => [unit, unit] as const)])}
          value={choice.unit}
          onChoose={(unit) => put(withUnit(shown.document, shown.choices, [table, column], unit))}
        />
      ) : null}
      {target?.is_required ? (
        <input
          aria-label={`factor of ${name}`}
          inputMode="decimal"
          placeholder="factor of pulses"
          size={12}
          value={choice.factor ?? ""}
          onInput={(event) => change({factor: withPoint(event.currentTarget.value)})}
        />
      ) : null}
    </>
  );
}
