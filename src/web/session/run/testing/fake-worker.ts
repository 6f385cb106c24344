import type { WorkerPort } from '../run-client';
import { answerHex, type HexRequest } from '../worker/hex';
import type { FromWorker, ToWorker } from '../worker/protocol';

/** A worker that runs no program: it says what the test says for it, answers a stop at once, and writes a hex. */
export function fakeWorker() {
  const sent: ToWorker[] = [];
  let current: WorkerPort | null = null;
  const say = (data: FromWorker): void => current?.onmessage?.({ data } as MessageEvent<FromWorker>);
  const createWorker = (): WorkerPort => {
    const worker: WorkerPort = {
      onmessage: null,
      onerror: null,
      postMessage(message: ToWorker | HexRequest) {
        if (message.type === 'make-hex') {
          queueMicrotask(() => worker.onmessage?.({ data: answerHex(message) } as never));
          return;
        }
        sent.push(message);
        if (message.type === 'run') current = worker;
        if (message.type === 'stop') queueMicrotask(() => say({ type: 'stopped' }));
      },
      terminate: () => undefined,
    };
    return worker;
  };
  return { sent, say, engine: { createWorker, firmware: () => Promise.resolve({} as WebAssembly.Module) } };
}
