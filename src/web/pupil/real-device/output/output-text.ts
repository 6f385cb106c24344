import type { BoardText } from '../../../session/run/board/real-board';

/** Most characters that are shown. Chosen: as many lines as somebody reads. */
const SHOWN = 20_000;
/** The colours and movements of a terminal, which are none here. */
const ESCAPES = /\x1b\[[0-9;?]*[@-~]|\x1b[^[]/g;

/** The text of a board to read: its end, in plain lines. */
export function outputText(output: readonly BoardText[]): string {
  let text = '';
  for (let place = output.length - 1; place >= 0 && text.length < SHOWN; place--) text = (output[place]?.text ?? '') + text; // prettier-ignore
  const lines = text.slice(-SHOWN).replaceAll(ESCAPES, '').replaceAll('\r\n', '\n');
  return lines.replaceAll('\r', '').replaceAll(/[\b\x7f]/g, '');
}
