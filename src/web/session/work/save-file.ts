import type { SourceFile } from '#project/project';

import { sayMayBeRefused } from '../../kit/bar/frame-limits';
import type { PageParts } from '../../kit/parts';

/** A name for a file of a course: what file systems do not allow is left out. */
export function fileName(course: string, ending: string): string {
  const base = Array.from(course.normalize('NFC'))
    .filter((sign) => sign >= ' ' && !'\\/:*?"<>|\u007f'.includes(sign))
    .slice(0, 60)
    .join('')
    .replace(/^[.\s]+|[.\s]+$/g, '');
  return `${base === '' ? 'parcours' : base}.${ending}`;
}

/** Hands a file to the browser's downloads. @returns whether the page has said that the frame may refuse it */
export function saveBlob(name: string, blob: Blob): boolean {
  const url = URL.createObjectURL(blob);
  const link = document.createElement('a');
  link.href = url;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 60_000); // Safari reads the file after the click has returned
  return sayMayBeRefused();
}

/** Saves a text as a download, and shows a notice. */
export function saveText({ notices }: Pick<PageParts, 'notices'>, name: string, text: string, type: string): void {
  const isSaid = saveBlob(name, new Blob([text], { type }));
  if (!isSaid) notices.show({ kind: 'ok', key: 'files.saved', values: { file: name } });
}

/** Saves a file of the work as a download. */
export function saveFile(parts: Pick<PageParts, 'notices'>, file: SourceFile): void {
  saveText(parts, file.name, file.text, 'text/x-python');
}
