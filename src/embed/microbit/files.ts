import { FILE_BYTES, MAIN, projectLimits, type SourceFile } from '#project/project';

/**
 * The files of a `flash` as the page has them: `main.py` first; where it is missing an empty one, after which the REPL
 * comes at once as on the board.
 *
 * @returns a problem in one English sentence when there are too many or too large ones, or one that is no text: the page
 * shows and keeps what a program is made of as text
 */
export function filesOf(
  filesystem: Readonly<Record<string, Uint8Array>>,
): { readonly files: readonly SourceFile[] } | { readonly problem: string } {
  const names = Object.keys(filesystem);
  if (names.length > projectLimits.files)
    return { problem: `There are ${names.length} files; the limit is ${projectLimits.files}.` };
  const files: SourceFile[] = [];
  for (const [name, bytes] of Object.entries(filesystem)) {
    if (bytes.length > FILE_BYTES)
      return { problem: `${quoted(name)} has ${bytes.length} bytes; the limit is ${FILE_BYTES}.` };
    const text = textOf(bytes);
    if (text === null) return { problem: `${quoted(name)} is no UTF-8 text.` };
    if (name === MAIN) files.unshift({ name, text });
    else files.push({ name, text });
  }
  if (files[0]?.name !== MAIN) files.unshift({ name: MAIN, text: '' });
  return { files };
}

const quoted = (name: string): string => JSON.stringify(name.length > 60 ? `${name.slice(0, 60)}…` : name);

function textOf(bytes: Uint8Array): string | null {
  try {
    return new TextDecoder('utf-8', { fatal: true }).decode(bytes);
  } catch {
    return null;
  }
}
