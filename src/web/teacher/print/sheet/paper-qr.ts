import { qrCode, QR_RIM, type QrCode } from '../../../kit/links/qr-code';

/** A QR code on paper. */
export interface PaperQr extends QrCode {
  /** Side of one of its squares, in mm. */
  readonly squareMm: number;
}

/**
 * Sides of a QR code's squares on paper, in mm. Largest: the code of a short link is then as large as a stamp. Good: such
 * squares may be dirty or crumpled, so the code corrects more errors. Least: five dots of a printer with 300 dots an
 * inch; DENSO, who made the QR code, asks for four.
 */
const SQUARE_MM = { largest: 0.9, good: 0.5, least: 0.42 } as const;

/** Longest side of the code without its rim, in mm. Chosen: a third of the sheet's width; name and class stay beside it. */
const LONGEST_MM = 56;

/** Most characters of a link whose code can still be read from paper: a code of 133 squares (version 29). */
export const PAPER_QR_CHARACTERS = 1628;

/** The code of a link as it is printed; `null`: the link is too long for one that can be read. */
export function paperQr(link: string): PaperQr | null {
  for (const correction of ['medium', 'low'] as const) {
    const code = qrCode(link, correction);
    if (code === null) continue;
    const squareMm = Math.min(SQUARE_MM.largest, LONGEST_MM / (code.size - 2 * QR_RIM));
    if (squareMm >= (correction === 'medium' ? SQUARE_MM.good : SQUARE_MM.least)) return { ...code, squareMm };
  }
  return null;
}
