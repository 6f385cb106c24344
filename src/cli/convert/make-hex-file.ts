import { basename } from 'node:path';
import type { Firmware, HexBoard } from '#hex/firmware';
import type { FittingFiles } from '#hex/fitting-files';
import type { MadeHex } from '#hex/hex';
import { hardwareOf } from '#intake/webtigerpython';
import { unreadHex } from '#intake/hex-document';
import { unreadText } from '#check/report/say';
import { limits } from '#intake/formats';
import type { SourceFile } from '#project/project';
import { readLimited } from '../read-files';
import type { ConvertOptions } from './convert-arguments';
import type { Made } from './made';
import type { Input } from './read-input';

type Problem = { readonly problem: string };

/** Maximum number of files that are named where there is no room. */
const MOST_NAMES = 4;

/** A hex for the boards of the firmwares: the program, its modules, and those of ours that it imports. */
export async function makeHexFile(
  { work }: Input,
  { firmware, board, files: paths }: ConvertOptions,
): Promise<Made | Problem> {
  const firmwares = await readFirmwares(firmware, board);
  if ('problem' in firmwares) return firmwares;
  const own = withFiles(work.files, paths);
  if ('problem' in own) return own;
  const hardware = hardwareOf({ ...work, files: own });
  const robot = 'problem' in hardware ? null : (hardware.robot?.id ?? null);
  const { fittingFiles } = await import('#hex/fitting-files');
  const { makeHex } = await import('#hex/make');
  const fitting = fittingFiles(own, robot, Math.min(...firmwares.map(({ roomBytes }) => roomBytes)));
  const hex = makeHex(firmwares, fitting.files);
  return hex.kind === 'hex' ? { text: hex.text, notes: notesOf(hex, fitting, firmwares) } : { problem: problemOf(hex) };
}

/** The MicroPython in the files of `--firmware` for the board that is wanted, or for all. */
async function readFirmwares(paths: readonly string[], board: HexBoard | null): Promise<readonly Firmware[] | Problem> {
  const { cleanFirmware } = await import('#hex/clean');
  const found: Firmware[] = [];
  for (const path of paths) {
    const file = readLimited(path, limits.hex);
    if ('problem' in file) return { problem: `--firmware: ${file.problem}` };
    const cleaned = cleanFirmware(file.text);
    if ('problem' in cleaned)
      return { problem: `--firmware: ${path}: ${unreadText(unreadHex(cleaned.problem), 'en')}` };
    found.push(...cleaned.firmwares);
  }
  const wanted = board === null ? found : found.filter((firmware) => firmware.board === board);
  const boards = found.map((firmware) => firmware.board).join(', ');
  return wanted.length > 0 ? wanted : { problem: `--board: the firmware is for ${boards}.` };
}

function withFiles(own: readonly SourceFile[], paths: readonly string[]): readonly SourceFile[] | Problem {
  const files = [...own];
  for (const path of paths) {
    const name = basename(path);
    if (files.some((file) => file.name === name)) return { problem: `--file: ${path}: there is already a file "${name}".` }; // prettier-ignore
    const file = readLimited(path, limits.program);
    if ('problem' in file) return { problem: `--file: ${file.problem}` };
    files.push({ name, text: file.text });
  }
  return files;
}

function notesOf(
  { usedBytes, roomBytes, filled }: Extract<MadeHex, { kind: 'hex' }>,
  { files, smaller, modules }: FittingFiles,
  firmwares: readonly Firmware[],
): readonly string[] {
  const brought = files.filter(({ isOwn }) => !isOwn).map(({ name }) => name);
  const isCalliope = firmwares.some(({ board }) => board.startsWith('calliope'));
  const calliope = modules.flat().filter((name) => name.startsWith('calliope'));
  return [
    ...firmwares.map(({ board, version, known }) => `For ${board}: ${known ?? `${version} (not tried)`}.`),
    `${usedBytes} of ${roomBytes} bytes are used.`,
    ...(brought.length === 0 ? [] : [`Brought along, since the program imports it: ${brought.join(', ')}.`]),
    ...(smaller.length === 0 ? [] : [`Without comments and spaces, so that it fits: ${smaller.join(', ')}.`]),
    ...(filled.length === 0 ? [] : [`Empty files have one empty line, since a board holds none that is empty: ${filled.join(', ')}.`]), // prettier-ignore
    ...(isCalliope || calliope.length === 0 ? [] : [`It imports ${calliope[0] ?? ''}, which only a Calliope mini has.`]), // prettier-ignore
  ];
}

function problemOf(hex: Exclude<MadeHex, { kind: 'hex' }>): string {
  switch (hex.kind) {
    case 'too-large': {
      const large = hex.large.slice(0, MOST_NAMES).map(({ name, bytes }) => `${name} (${bytes})`);
      return `does not fit: ${hex.missingBytes} bytes are missing, the board has room for ${hex.roomBytes}. Large: ${large.join(', ')}.`;
    }
    case 'name':
      return `the name "${hex.name}" cannot be on a board.`;
    case 'boards':
      return `a hex is for one board, or for the older and the newer one of a family; these are ${hex.boards.join(', ')}. Choose one: --board ${hex.boards[0] ?? ''}`; // prettier-ignore
  }
}
