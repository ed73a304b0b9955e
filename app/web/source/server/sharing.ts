// What is the same in two answers is one object, so that whoever looks at a part does not hear of a change elsewhere.

function isParted(value: unknown): value is Record<string, unknown> {
  return typeof value === "object" && value !== null;
}

/** `next`, with the parts of `before` where they are equal; `before` itself where all of it is. */
export function sharing<T>(before: unknown, next: T): T {
  if (Object.is(before, next) || !isParted(before) || !isParted(next) || Array.isArray(before) !== Array.isArray(next))
    return next;
  const shared = Object.entries(next).map(([key, part]) => [key, sharing(before[key], part)] as const);
  const isSame =
    shared.length === Object.keys(before).length &&
    shared.every(([key, part]) => key in before && part === before[key]);
  if (isSame) return before as T;
  return (Array.isArray(next) ? shared.map(([, part]) => part) : Object.fromEntries(shared)) as T;
}
