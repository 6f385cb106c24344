import { onBeforeUnmount, shallowRef } from 'vue';

import type { WithLate } from '../../../kit/state/late-models';
import { realBoard } from '../../../session/run/board/real-board';
import type { UsbEnd, UsbProgress } from './usb-board';
import type { BoardVersion, UsbProblem } from './usb-problem';

/** State of the transfer. */
export type UsbState =
  | { readonly kind: 'ready' }
  | { readonly kind: 'working'; readonly progress: UsbProgress }
  | { readonly kind: 'done'; readonly end: Extract<UsbEnd, { kind: 'done' }> }
  | { readonly kind: 'failed'; readonly problem: UsbProblem };

/**
 * The transfer of a program onto a board by USB. The board stays connected after it, so that its output can be seen.
 *
 * @param hexFor makes the hex for the board that is there; rejects with a `HexError`
 */
export function useUsbTransfer(app: WithLate, hexFor: (version: BoardVersion) => Promise<string>) {
  // Fetched with the way, not with the press: the browser shows its list of devices only shortly after a press.
  const late = import('./usb-board');
  const shown = realBoard(app);
  const state = shallowRef<UsbState>({ kind: 'ready' });
  const board = late.then(({ UsbBoard }) =>
    shown.value instanceof UsbBoard ? shown.value : new UsbBoard(() => (shown.value = null)),
  );
  onBeforeUnmount(async () => {
    const made = await board;
    made.stop();
    if (shown.value !== made) await made.disconnect();
  });

  async function put(): Promise<void> {
    if (state.value.kind === 'working') return;
    state.value = { kind: 'working', progress: { stage: 'connecting', extent: null, part: 0 } };
    const made = await board;
    // Two connections to one board would share its output.
    if (shown.value !== made) await shown.value?.disconnect();
    const end = await made.put(hexFor, (progress) => (state.value = { kind: 'working', progress }));
    if (end.kind === 'done') shown.value = made;
    if (end.kind === 'done') state.value = { kind: 'done', end };
    else state.value = end.kind === 'nothing' ? { kind: 'ready' } : { kind: 'failed', problem: end.problem };
  }

  return { state, put, stop: async (): Promise<void> => (await board).stop() };
}
