/** The browser's storage, or, in a frame that has none, one that forgets. */
export function pageStorage(): Pick<Storage, 'getItem' | 'setItem'> {
  try {
    return localStorage;
  } catch {
    return { getItem: () => null, setItem: () => undefined };
  }
}
