import { vi } from 'vitest';

/** A file that the browser was given to save. */
export interface Download {
  readonly name: string;
  readonly blob: Blob;
}

/**
 * The files that the browser saves from now on, oldest first; nothing leaves the test. `vi.restoreAllMocks()` ends
 * it.
 */
export function downloads(): readonly Download[] {
  const saved: Download[] = [];
  let last = new Blob();
  vi.spyOn(URL, 'createObjectURL').mockImplementation((blob) => {
    last = blob as Blob;
    return 'blob:test';
  });
  vi.spyOn(HTMLAnchorElement.prototype, 'click').mockImplementation(function (this: HTMLAnchorElement) {
    saved.push({ name: this.download, blob: last });
  });
  return saved;
}
