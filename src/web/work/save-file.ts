import { sayMayBeRefused } from '../page/bar/frame-limits';

/** A name for a file of a course: what file systems do not allow is left out. */
export function fileName(course: string, ending: string): string {
  const base = Array.from(course.normalize('NFC'))
    .filter((sign) => sign >= ' ' && !'\\/:*?"<>|\u007f'.includes(sign))
    .slice(0, 60)
    .join('')
    .replace(/^[.\s]+|[.\s]+$/g, '');
  return `${base === '' ? 'parcours' : base}.${ending}`;
}

/** Hands a file to the browser's downloads. */
export function saveBlob(name: string, blob: Blob): void {
  const url = URL.createObjectURL(blob);
  const link = document.createElement('a');
  link.href = url;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 60_000); // Safari reads the file after the click has returned
  sayMayBeRefused();
}
