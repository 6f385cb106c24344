import { RecordingSimulator } from '../../testing/recording-simulator';
import { createMicrobitAdapter } from '../adapter';
import type { MicrobitEvent } from '../messages';

/** A text as the bytes of a file. */
export const bytes = (text: string): Uint8Array => new TextEncoder().encode(text);

/** An adapter on a simulator that records what is done to it, with the messages of the adapter so far. */
export function opened(wish: Parameters<typeof createMicrobitAdapter>[2] = {}) {
  const simulator = new RecordingSimulator();
  const said: MicrobitEvent[] = [];
  const adapter = createMicrobitAdapter(
    simulator,
    { post: (message) => void said.push(message as MicrobitEvent), nowMs: () => 0 },
    wish,
  );
  const [start] = said;
  if (start === undefined) throw new Error('The adapter has said nothing.');
  /** The messages since the last call. */
  const news = (): MicrobitEvent[] => said.splice(0);
  const flash = async (source = 'print(1)'): Promise<void> => {
    adapter.receive({ kind: 'flash', filesystem: { 'main.py': bytes(source) } });
    await settled();
  };
  return { simulator, adapter, news, flash, start };
}

/** Waits until started actions have come to their next step. */
export const settled = (): Promise<void> => new Promise((resolve) => setTimeout(resolve));
/** The kinds of messages, in their order. */
export const kinds = (messages: readonly MicrobitEvent[]): string[] => messages.map(({ kind }) => kind);
