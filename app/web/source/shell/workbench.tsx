// The workbench page: header, views on a rail, dialogs, and notices common to all views.
import type {ComponentType} from "preact";
import {lazy, Suspense} from "preact/compat";
import {useEffect} from "preact/hooks";
import {connection, state} from "../server/workbench";
import {ErrorView} from "../error/error_view";
import {CalibrateView} from "../calibrate/calibrate_view";
import {EffectsView} from "../effects/effects_view";
import {OutageView} from "../outage/outage_view";
import {SheetView} from "../sheet/sheet_view";
import {DropTarget} from "./drop_target";
import {Header} from "./header";
import {JoinDialog} from "./join_dialog";
import {KeysDialog, followKeys} from "./keys";
import {Notices} from "./notices";
import {ChoiceDialog} from "./choice_dialog";
import {ColumnsDialog} from "./columns_dialog";
import {OpenDialog} from "./open_dialog";
import {dialog, view, VIEWS, type ViewName} from "./page_state";
import {SaveDialog, UnsavedDialog} from "./project";
import {Rail} from "./rail";
import {Waiting} from "./states";

// Views with an arm include the 3-D library, which is fetched when such a view is first opened.
const ArmView = lazy(() => import("../arm/arm_view"));
const PlanView = lazy(() => import("../plan/plan_view"));

const SHOWN: Record<ViewName, ComponentType> = {
  sheet: SheetView,
  arm: ArmView,
  error: ErrorView,
  plan: PlanView,
  calibrate: CalibrateView,
  effects: EffectsView,
  outage: OutageView,
};

function CurrentView({name}: {name: ViewName}) {
  if (state.value === null) {
    return connection.value === "lost" ? (
      <Waiting words="The program does not respond. Check whether it still runs in its terminal; this page reconnects by itself." />
    ) : (
      <Waiting words="Asking the program for its cell" isBusy />
    );
  }
  const View = SHOWN[name];
  return <View />;
}

export function Workbench() {
  useEffect(followKeys, []);
  return (
    <div class="workbench">
      <a
        class="skip"
        href="#view"
        onClick={(event) => {
          event.preventDefault();
          document.getElementById("view")?.focus();
        }}
      >
        To the view
      </a>
      <Header />
      <Rail />
      <main id="view" class={`view view-${view.value}`} tabIndex={-1}>
        <h1 class="hidden">{VIEWS.find(({name}) => name === view.value)?.words}</h1>
        <Suspense fallback={<Waiting words="Opening the view" isBusy />}>
          <CurrentView name={view.value} />
        </Suspense>
      </main>
      {state.value !== null && connection.value === "lost" ? (
        <p class="silence" role="alert">
          The program does not respond: the page shows the last state that it received. See whether it still runs in its
          terminal; the page reconnects by itself.
        </p>
      ) : null}
      {dialog.value === "" ? <Notices /> : null}
      <OpenDialog />
      <ColumnsDialog />
      <KeysDialog />
      <SaveDialog />
      <UnsavedDialog />
      <JoinDialog />
      <ChoiceDialog />
      <DropTarget />
    </div>
  );
}
