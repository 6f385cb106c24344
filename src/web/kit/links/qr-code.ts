import encodeQR from 'qr';

/**
 * The levels of error correction, by how much of a code may be hidden or dirty, each with the most characters that the
 * largest code holds as bytes (ISO/IEC 18004).
 */
const CHARACTERS = { low: 2953, medium: 2331 } as const;

/** Most characters of a QR code with the least error correction. */
export const QR_CHARACTERS = CHARACTERS.low;

/** Free squares around a code. */
export const QR_RIM = 4;

/** Dark squares side by side. */
export interface QrRun {
  readonly x: number;
  readonly y: number;
  readonly length: number;
}

/** A QR code as its dark squares, a unit each. */
export interface QrCode {
  /** Squares along a side, with the rim. */
  readonly size: number;
  readonly runs: readonly QrRun[];
}

/**
 * A link as a QR code.
 *
 * @param correction on a screen nothing is dirty or torn: the least gives the largest squares
 * @returns `null` when the link is too long
 */
export function qrCode(link: string, correction: keyof typeof CHARACTERS = 'low'): QrCode | null {
  if (link.length > CHARACTERS[correction]) return null;
  const rows = encodeQR(link, 'raw', { ecc: correction, encoding: 'byte', border: QR_RIM });
  return { size: rows.length, runs: rows.flatMap(runsOf) };
}

/** The dark squares of the QR code of a link as an SVG path; `null` when the link is too long. */
export function qrPath(link: string): { readonly path: string; readonly size: number } | null {
  const code = qrCode(link);
  return code && { path: pathOf(code), size: code.size };
}

/** The dark squares of a code as an SVG path. */
export const pathOf = ({ runs }: QrCode): string =>
  runs.map(({ x, y, length }) => `M${x} ${y}h${length}v1h-${length}z`).join('');

function runsOf(row: readonly boolean[], y: number): readonly QrRun[] {
  const runs: { x: number; y: number; length: number }[] = [];
  for (const [x, isDark] of row.entries()) {
    if (!isDark) continue;
    const last = runs.at(-1);
    if (last !== undefined && last.x + last.length === x) last.length += 1;
    else runs.push({ x, y, length: 1 });
  }
  return runs;
}
