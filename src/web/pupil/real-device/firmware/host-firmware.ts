import { sha256 } from '@noble/hashes/sha2.js';
import { bytesToHex } from '@noble/hashes/utils.js';

import { hexBoards, type HexBoard } from '#hex/firmware';

/** A firmware beside the app on its web server. */
export interface HostFirmware {
  readonly board: HexBoard;
  /** Name of its file, a hex, in the folder. */
  readonly file: string;
  /** SHA-256 of that file, in hexadecimal digits. */
  readonly sha256: string;
}

/** The folder, beside the app; `docs/hosting.md` tells what belongs into it. */
export const FOLDER = 'firmware/';
/** The list of its firmwares, in it. */
export const LIST = 'firmware.json';

/** The part of the browser that fetches, so that tests can be a server. */
export type Fetch = (address: string, how?: RequestInit) => Promise<Pick<Response, 'ok' | 'arrayBuffer'>>;

const addressOf = (file: string): string => new URL(FOLDER + encodeURIComponent(file), document.baseURI).href;

/** The firmwares that the web server offers; none when it has no list, or one that cannot be read. */
export async function hostFirmwares(get: Fetch): Promise<readonly HostFirmware[]> {
  const bytes = await fetched(get, LIST, { cache: 'no-cache' });
  if (bytes === null) return [];
  try {
    const list = JSON.parse(new TextDecoder().decode(bytes)) as { readonly firmwares?: unknown } | null;
    return Array.isArray(list?.firmwares) ? list.firmwares.filter(isEntry) : [];
  } catch {
    return [];
  }
}

/** The text of a firmware's file; `null` when it does not come, or is not the one that its hash says. */
export async function hostHex({ file, sha256: sum }: HostFirmware, get: Fetch): Promise<string | null> {
  const bytes = await fetched(get, file);
  if (bytes === null || bytesToHex(sha256(bytes)) !== sum.toLowerCase()) return null;
  return new TextDecoder().decode(bytes);
}

async function fetched(get: Fetch, file: string, how?: RequestInit): Promise<Uint8Array | null> {
  try {
    const answer = await get(addressOf(file), how);
    return answer.ok ? new Uint8Array(await answer.arrayBuffer()) : null;
  } catch {
    return null;
  }
}

function isEntry(entry: unknown): entry is HostFirmware {
  const { board, file, sha256: sum } = (entry ?? {}) as Readonly<Record<string, unknown>>;
  const isBoard = hexBoards.some((known) => known === board);
  return isBoard && typeof file === 'string' && typeof sum === 'string' && /^[0-9a-f]{64}$/i.test(sum);
}
