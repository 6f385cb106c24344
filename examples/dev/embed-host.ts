import { createParcoursAdapter } from '#embed/parcours/adapter';
import { RecordingSimulator } from '#embed/testing/recording-simulator';

import type { Print } from './example';

/** embed: a host speaks to the simulator without a page: it says hello, sends a program, and is told what happens. */
export function main(print: Print): void {
  const simulator = new RecordingSimulator();
  const post = (message: object): void => {
    const { reply, ok, type } = message as Readonly<Record<string, string | number | boolean | undefined>>;
    print(reply === undefined ? `event ${String(type)}` : `answer ${String(reply)}: ${String(ok)}`);
  };
  const facts = { app: '1.0.0', page: 'p1', devices: ['microbit-v2'], robots: ['maqueen-lite'], courses: ['push'] };
  const host = createParcoursAdapter(simulator, { post, nowMs: () => 0 }, facts);
  host.receive({ parcours: 1, id: 1, type: 'hello' });
  host.receive({ parcours: 1, id: 2, type: 'set-files', files: [{ name: 'main.py', text: 'print(1)' }] });
  simulator.tell({ type: 'started' });
  host.close();
}
