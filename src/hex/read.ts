import type { HexBoard, Region } from './firmware';
import { appendedScript, storedFiles, type StoredFile } from './file-system';
import type { HexFile, HexMade, HexNote, HexResult } from './hex';
import { boardOf } from './image';
import { layoutOf } from './layout';
import { parseHex, type HexPart, type ParsedHex } from './parse';

const MAIN = 'main.py';

/** Stands before the source in a file of MakeCode. */
const MAKECODE = '41140E2FB82FA2BB';

/** The boards of the numbers in a universal hex; two numbers were in use for the micro:bit V1. */
const boards: ReadonlyMap<number, HexBoard> = new Map([
  ...[0x9900, 0x9901].map((id) => [id, 'microbit-v1'] as const),
  ...[0x9903, 0x9904, 0x9905, 0x9906].map((id) => [id, 'microbit-v2'] as const),
]);

/** Reads any hex: which boards it is for, how it was made, and the files in it. Never throws. */
export function readHex(text: string): HexResult {
  const parsed = parseHex(text);
  if ('problem' in parsed) return { kind: 'problem', problem: parsed.problem };
  const read = parsed.parts.map(readPart);
  const isUniversal = parsed.parts.some(({ boardId }) => boardId !== null);
  const pythons = read.filter((part) => part !== null);
  if (pythons.length === 0) {
    const made: HexMade = isMakeCode(text, parsed) ? 'makecode' : 'unknown';
    return hexOf(made, parsed.parts.flatMap(boardOfPart), [], []);
  }
  const withFiles = pythons.find(({ files }) => files === null || files.length > 0) ?? pythons[0];
  const files = withFiles?.files ?? null;
  if (files === null) return { kind: 'problem', problem: { code: 'files' } };
  if (pythons.some((part) => !isSame(part.files, files))) return { kind: 'problem', problem: { code: 'parts' } };
  const made = pythons.every(({ isAppended }) => isAppended) ? 'micropython-appended' : 'micropython';
  const said = pythons.map(({ version }) => version);
  return hexOf(isUniversal ? 'universal' : made, pythons.map(({ board }) => board), files, said); // prettier-ignore
}

/** True if MakeCode has made it: it keeps its source beside the boards' bytes. */
export const isMakeCode = (text: string, { hasOtherData }: ParsedHex): boolean =>
  hasOtherData || text.toUpperCase().includes(MAKECODE);

interface PythonPart {
  readonly board: HexBoard;
  readonly version: string;
  /** `null`: they are damaged. */
  readonly files: readonly StoredFile[] | null;
  readonly isAppended: boolean;
}

/** The Python in the bytes of a board; `null`: there is none. */
function readPart({ regions }: HexPart): PythonPart | null {
  const layout = layoutOf(regions);
  const script = appendedScript(regions);
  if (layout === null) return script === null ? null : oldest(regions, script);
  const files = storedFiles(regions, layout);
  const [board, version] = [boardOf(regions, layout.isOldChip), layout.version];
  if (files !== null && files.length === 0 && script !== null)
    return { board, version, files: [{ name: MAIN, bytes: script }], isAppended: true };
  return { board, version, files, isAppended: false };
}

/** Python before it could keep files says nothing about itself. */
const oldest = (regions: readonly Region[], script: Uint8Array): PythonPart => ({
  board: boardOf(regions, true),
  version: '',
  files: [{ name: MAIN, bytes: script }],
  isAppended: true,
});

const boardOfPart = ({ boardId }: HexPart): readonly HexBoard[] => {
  const board = boardId === null ? undefined : boards.get(boardId);
  return board === undefined ? [] : [board];
};

const isSame = (some: readonly StoredFile[] | null, others: readonly StoredFile[]): boolean =>
  some?.length === others.length &&
  some.every(({ name, bytes }) => {
    const other = others.find((file) => file.name === name)?.bytes;
    return other?.length === bytes.length && bytes.every((byte, index) => byte === other[index]);
  });

function hexOf(
  made: HexMade,
  read: readonly HexBoard[],
  stored: readonly StoredFile[],
  versions: readonly string[],
): HexResult {
  // prettier-ignore
  const notes: HexNote[] = [];
  const files: HexFile[] = [];
  for (const { name, bytes } of stored) {
    const text = textOf(bytes);
    if (text === null) notes.push({ code: 'not-text', file: name });
    else files.push({ name, text });
  }
  if (stored.length === 0 && versions.length > 0) notes.push({ code: 'no-files' });
  files.sort((a, b) => rank(a) - rank(b));
  const program = files.find(({ name }) => name === MAIN)?.text ?? null;
  return { kind: 'hex', made, boards: read, versions, program, files, notes };
}

const rank = ({ name }: HexFile): number => (name === MAIN ? 0 : 1);

function textOf(bytes: Uint8Array): string | null {
  try {
    return new TextDecoder('utf-8', { fatal: true, ignoreBOM: true }).decode(bytes);
  } catch {
    return null;
  }
}
