// Chosen tabs of the error view, which other parts of the view open as well.
import {signal} from "@preact/signals";

export type EffectsTab = "effects" | "steps" | "split" | "formula" | "numbers";
export const effectsTab = signal<EffectsTab>("effects");

export type EvidenceTab = "places" | "joints" | "histogram" | "readings";
export const evidenceTab = signal<EvidenceTab>("places");
