// Documents of the program's server, as far as the page reads them. Quantities are in the cell's units.
export type * from "./calibration_documents";
export type * from "./common_documents";
export type * from "./error_documents";
export type * from "./geometry_documents";
export type * from "./plan_documents";
export type * from "./state_documents";
