import encodeQR from 'qr';

/** Most characters that a QR code of the largest kind holds as bytes, with the least error correction (ISO/IEC 18004). */
export const QR_CHARACTERS = 2953;

/**
 * A link as the drawing of a QR code: an SVG path of its dark squares, a unit each.
 *
 * @returns `null` when the link is too long
 */
export function qrPath(link: string): { readonly path: string; readonly size: number } | null {
  if (link.length > QR_CHARACTERS) return null;
  // On a screen nothing is dirty or torn: the least correction gives the largest squares.
  const rows = encodeQR(link, 'raw', { ecc: 'low', encoding: 'byte', border: 4 });
  const runs = rows.flatMap((row, y) => runsOf(row).map(([x, length]) => `M${x} ${y}h${length}v1h-${length}z`));
  return { path: runs.join(''), size: rows.length };
}

/** Dark squares side by side, as start and length. */
function runsOf(row: readonly boolean[]): readonly (readonly [start: number, length: number])[] {
  const runs: [number, number][] = [];
  for (const [x, isDark] of row.entries()) {
    if (!isDark) continue;
    const last = runs.at(-1);
    if (last !== undefined && last[0] + last[1] === x) last[1] += 1;
    else runs.push([x, 1]);
  }
  return runs;
}
