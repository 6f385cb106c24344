/** Asks for files in a dialog of the browser: of these kinds, from the camera if it is wished. */
export function pickFiles(
  wish: { readonly accept: string; readonly multiple?: boolean; readonly camera?: boolean },
  take: (files: readonly File[]) => void,
): void {
  const picker = document.createElement('input');
  picker.type = 'file';
  picker.accept = wish.accept;
  picker.multiple = wish.multiple === true;
  if (wish.camera === true) picker.capture = 'environment';
  picker.addEventListener('change', () => take([...(picker.files ?? [])]));
  picker.click();
}

/** The kinds of pictures that a course can have. */
export const PICTURES = 'image/png,image/jpeg,image/svg+xml';
