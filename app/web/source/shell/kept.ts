// Storage of this browser for the user, by name: objects that may be missing, damaged or of an earlier version.

export function keptObject<T>(key: string): Record<string, T> {
  try {
    const kept = JSON.parse(localStorage.getItem(key) ?? "{}");
    return kept !== null && typeof kept === "object" && !Array.isArray(kept) ? kept : {};
  } catch {
    return {};
  }
}

export function keep<T>(key: string, object: Record<string, T>): void {
  try {
    localStorage.setItem(key, JSON.stringify(object));
  } catch {
    // A browser without storage asks again each time.
  }
}
