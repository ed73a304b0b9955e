import {describe, expect, it} from "vitest";
import {sharing} from "../source/server/sharing";

describe("two answers", () => {
  const before = {revision: 1, cell: {units: {length: "in"}}, models: [{id: 0}, {id: 1, effects: ["a"]}], none: null};
  const copied = (): typeof before => JSON.parse(JSON.stringify(before));

  it("are one where nothing changed", () => {
    expect(sharing(before, copied())).toBe(before);
  });
  it("share the parts that are equal, and those alone", () => {
    const next = copied();
    next.revision = 2;
    next.models[1].effects = ["b"];
    const shared = sharing(before, next);
    expect(shared).toEqual(next);
    expect(shared.cell).toBe(before.cell);
    expect(shared.models[0]).toBe(before.models[0]);
    expect(shared.models[1]).not.toBe(before.models[1]);
  });
  it("differ where a part is gone, has come, or is of another kind", () => {
    expect(sharing({a: 1, b: 2}, {a: 1})).toEqual({a: 1});
    expect(sharing<object>({a: 1}, {a: 1, b: undefined})).toEqual({a: 1, b: undefined});
    expect(sharing<object>({a: 1}, {b: 1})).toEqual({b: 1});
    expect(sharing<unknown>([], {})).toEqual({});
    expect(sharing<unknown>({0: 1}, [1])).toEqual([1]);
    expect(sharing<unknown>(null, {a: null})).toEqual({a: null});
    expect(sharing([1, 2], [1])).toEqual([1]);
  });
});
