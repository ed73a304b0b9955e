// Common parts of views that show the tube sheet: a note if the cell has no sheet, and a panel with the sheet picture.
import type {ComponentChildren} from "preact";
import {cell, sheetDocument, units} from "../server/workbench";
import {sheet} from "../shell/page_state";
import {Nothing, ProblemWords, Waiting} from "../shell/states";
import type {SheetPictureProps} from "./sheet_drawing";
import type {SheetModel} from "./sheet_model";
import {SheetPicture} from "./sheet_picture";

interface WithSheetProps {
  without: ComponentChildren;
  children: (model: SheetModel) => ComponentChildren;
}

/** Shows `children` once the sheet is loaded; `without` is the text for a cell without a sheet. */
export function WithSheet({without, children}: WithSheetProps) {
  const {problem} = sheetDocument.value;
  if (cell.value && !cell.value.has_sheet)
    return <Nothing title={`${cell.value.name} has no tube sheet`}>{without}</Nothing>;
  if (problem)
    return (
      <Nothing title="The sheet cannot be shown">
        <ProblemWords problem={problem} />
      </Nothing>
    );
  return sheet.value ? <>{children(sheet.value)}</> : <Waiting words="Reading the sheet" isBusy />;
}

interface SheetPanelProps extends Omit<SheetPictureProps, "unit"> {
  head: ComponentChildren;
  headClass?: string;
  over?: ComponentChildren;
  foot?: ComponentChildren;
}

export function SheetPanel({head, headClass, over, foot, ...picture}: SheetPanelProps) {
  return (
    <section class="panel">
      <header class={headClass}>{head}</header>
      <div class="panel-body flush">
        <SheetPicture unit={units.value.length} {...picture} />
        {over}
      </div>
      {foot ? <footer class="stage-foot">{foot}</footer> : null}
    </section>
  );
}
