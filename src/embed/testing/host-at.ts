import { createParcoursAdapter } from '../parcours/adapter';
import type { EventName } from '../parcours/protocol';
import { RecordingSimulator } from './recording-simulator';

/** The page's data about itself. */
const facts = { app: '0.1.0', page: 'p1', devices: ['microbit-v2'], robots: ['maqueen-lite'], courses: ['push'] };

/** A message of the page. */
export type Message = Readonly<Record<string, unknown>>;

/** A host of our own dialect at the adapter of a page that runs nothing. */
export function hostAt(start: ConstructorParameters<typeof RecordingSimulator>[0] = {}) {
  const simulator = new RecordingSimulator(start);
  const heard: Message[] = [];
  const time = { ms: 0 };
  const connection = { post: (message: object) => void heard.push(message as Message), nowMs: () => time.ms };
  const adapter = createParcoursAdapter(simulator, connection, facts);
  let id = 0;
  const say = (type: string, fields: object = {}): number => {
    id += 1;
    adapter.receive({ parcours: 1, id, type, ...fields });
    return id;
  };
  const answerTo = (asked: number): Message | undefined => heard.find(({ reply }) => reply === asked);
  const ask = (type: string, fields: object = {}): Message | undefined => answerTo(say(type, fields));
  const events = (type: EventName): readonly Message[] => heard.filter((message) => message['type'] === type);
  return { simulator, heard, time, adapter, say, ask, answerTo, events };
}

/** The same after its hello. */
export function greeted(start: ConstructorParameters<typeof RecordingSimulator>[0] = {}) {
  const host = hostAt(start);
  host.ask('hello');
  return host;
}

/** Waits until all promises are settled. */
export async function settled(): Promise<void> {
  for (let times = 0; times < 3000; times += 1) await Promise.resolve();
}
