import { describe, expect, it, vi } from 'vitest';
import { LookClient, type Look, type LookWish } from './look-client';

function worker() {
  return {
    postMessage: vi.fn<(message: { readonly type: string; readonly ask?: number }) => void>(),
    terminate: vi.fn(),
    onmessage: null as ((event: MessageEvent) => void) | null,
    onerror: null,
  };
}
const setup = {} as never;
const wish: LookWish = { kind: 'moment', at: { device: 0, timeUs: 5, isLine: false } };
const look = { device: 0, timeUs: 5, isLine: false } as Look;

function opened(firmware: () => Promise<WebAssembly.Module> = () => Promise.resolve({} as WebAssembly.Module)) {
  const port = worker();
  const client = new LookClient({ createWorker: () => port, firmware, setup });
  const say = (data: unknown): void => port.onmessage?.({ data } as MessageEvent);
  return { client, port, say };
}
const asked = async (port: ReturnType<typeof worker>, times: number): Promise<void> =>
  vi.waitFor(() => expect(port.postMessage.mock.calls.filter(([{ type }]) => type === 'look')).toHaveLength(times));

describe('looking into a run that has been', () => {
  it('opens the run once, and gives what the worker has seen', async () => {
    const { client, port, say } = opened();
    const answer = client.look(wish);
    await asked(port, 1);
    say({ type: 'looked', ask: 1, look });
    expect(await answer).toBe(look);
    expect(port.postMessage.mock.calls.map(([{ type }]) => type)).toEqual(['look-into', 'look']);
  });

  it('gets near a moment beforehand, but never in the way of a wish', async () => {
    const { client, port } = opened();
    await client.prepare(wish.at);
    void client.look(wish);
    await asked(port, 1);
    await client.prepare(wish.at);
    expect(port.postMessage.mock.calls.map(([{ type }]) => type)).toEqual(['look-into', 'look-near', 'look']);
  });

  it('gives nothing to a wish that a newer one has overtaken', async () => {
    const { client, port, say } = opened();
    const [first, second] = [client.look(wish), client.look(wish)];
    await asked(port, 2);
    say({ type: 'looked', ask: 1, look });
    say({ type: 'looked', ask: 2, look });
    expect([await first, await second]).toEqual([null, look]);
  });

  it('gives nothing when looking fails, when it is ended, and without a connection', async () => {
    const { client, port, say } = opened();
    const failed = client.look(wish);
    await asked(port, 1);
    say({ type: 'look-failed', message: 'no memory' });
    expect(await failed).toBeNull();
    const ended = client.look(wish);
    client.end();
    expect(await ended).toBeNull();
    await vi.waitFor(() => expect(port.terminate).toHaveBeenCalledOnce());
    expect(await opened(() => Promise.reject(new Error('offline'))).client.look(wish)).toBeNull();
  });
});
