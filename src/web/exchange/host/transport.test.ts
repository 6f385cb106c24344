import { describe, expect, it } from 'vitest';

import type { Adapter, HostConnection } from '#embed/adapter';

import { openTransport, type TransportOptions, type HostMessage } from './transport';

const HOST = 'https://host.example';

/** A transport whose adapters record what they receive; their own messages go out. */
function transportOf(options: Partial<TransportOptions> = {}) {
  const sent: { readonly message: object; readonly target: string }[] = [];
  const parent = { postMessage: (message: object, target: string) => void sent.push({ message, target }) };
  const heard: unknown[] = [];
  const connections: HostConnection[] = [];
  let closed = 0;
  const open = (connection: HostConnection): Promise<Adapter> => {
    connections.push(connection);
    return Promise.resolve({
      receive: (message: unknown) => void heard.push(message),
      close: () => void (closed += 1),
    });
  };
  const unasked: unknown[] = [];
  const transport = openTransport({
    parent,
    allowed: null,
    openOurs: open,
    openUnasked: (connection) => {
      connection.post({ type: 'pythonReady' });
      return Promise.resolve({ receive: (message) => void unasked.push(message), close: () => undefined });
    },
    nowMs: () => 0,
    onMissing: () => undefined,
    ...options,
  });
  const say = async (data: unknown, more: Partial<HostMessage> = {}): Promise<void> => {
    transport.receive({ data, origin: HOST, source: parent, ports: [], ...more });
    for (let times = 0; times < 5; times += 1) await Promise.resolve();
  };
  return { transport, say, sent, heard, unasked, connections, closed: () => closed };
}

const hello = (session?: string) => ({
  parcours: 1,
  id: 1,
  type: 'hello',
  ...(session === undefined ? {} : { session }),
});
const run = { parcours: 1, id: 2, type: 'run' };

describe('the transport for host pages', () => {
  it('hears the parent and nobody else', async () => {
    const { say, heard, unasked } = transportOf();
    await say(hello(), { source: {} });
    await say(hello(), { source: null });
    await say({ type: 'run_code' }, { source: {} });
    expect([heard, unasked]).toEqual([[], []]);
    await say(hello());
    expect(heard).toEqual([hello()]);
  });

  it('answers the origin that said hello by its name, and listens to no other from then on', async () => {
    const { say, heard, sent, connections } = transportOf({ openUnasked: null });
    await say(hello());
    await say(run, { origin: 'https://other.example' });
    await say(hello(), { origin: 'https://other.example' });
    await say(run);
    expect(heard).toEqual([hello(), run]);
    connections[0]?.post({ parcours: 1 });
    expect(sent).toEqual([{ message: { parcours: 1 }, target: HOST }]);
  });

  it('can only answer everybody where the host has no origin', async () => {
    const { say, sent, connections } = transportOf({ openUnasked: null });
    await say(hello(), { origin: 'null' });
    connections[0]?.post({ parcours: 1 });
    expect(sent).toEqual([{ message: { parcours: 1 }, target: '*' }]);
  });

  it('lets only the named origins speak, and tells only them what it says unasked', async () => {
    const { say, sent, heard, unasked } = transportOf({ allowed: [HOST] });
    expect(sent).toEqual([{ message: { type: 'pythonReady' }, target: HOST }]);
    await say(hello(), { origin: 'https://other.example' });
    await say({ type: 'run_code' }, { origin: 'https://other.example' });
    expect([heard, unasked]).toEqual([[], []]);
    await say({ type: 'run_code' });
    expect(unasked).toEqual([{ type: 'run_code' }]);
  });

  it('tells a host that goes on after the page was loaded anew to begin again', async () => {
    const { say, sent, heard } = transportOf({ openUnasked: null });
    await say(run);
    expect(sent).toEqual([
      { message: expect.objectContaining({ reply: 2, ok: false, code: 'no-hello' }), target: HOST },
    ]);
    await say({ ...run, id: { no: 'id' } });
    expect(sent.length).toBe(1);
    expect(heard).toEqual([]);
  });

  it('goes on with the same conversation when hello is repeated, and begins another one for another session', async () => {
    const { say, heard, connections, closed } = transportOf();
    await say(hello('a'));
    await say(hello('a'));
    expect([connections.length, heard.length, closed()]).toEqual([1, 2, 0]);
    await say(hello('b'));
    expect([connections.length, closed()]).toEqual([2, 1]);
  });

  it('speaks over the port that came with hello, and no more over the window', async () => {
    const { say, heard, sent, connections, transport } = transportOf({ openUnasked: null });
    const { port1, port2 } = new MessageChannel();
    const arrived = new Promise((resolve) => (port1.onmessage = ({ data }) => resolve(data)));
    await say(hello('a'), { ports: [port2] });
    await say(run);
    expect(heard).toEqual([hello('a')]);
    connections[0]?.post({ parcours: 1, reply: 1 });
    expect(await arrived).toEqual({ parcours: 1, reply: 1 });
    port1.postMessage(run);
    await new Promise((resolve) => setTimeout(resolve, 20));
    expect(heard).toEqual([hello('a'), run]);
    expect(sent).toEqual([]);
    transport.close();
    port1.close();
  });

  it('takes another hello when the port was closed in the middle', async () => {
    const { say, connections } = transportOf({ openUnasked: null });
    const { port1, port2 } = new MessageChannel();
    await say(hello('a'), { ports: [port2] });
    port1.close();
    await new Promise((resolve) => setTimeout(resolve, 20));
    connections[0]?.post({ parcours: 1 });
    await say(hello('a'));
    expect(connections.length).toBe(2);
  });

  it('keeps what is said until the code of the dialect is there', async () => {
    let arrive = (_adapter: Adapter): void => undefined;
    const heard: unknown[] = [];
    const openOurs = () => new Promise<Adapter>((resolve) => (arrive = resolve));
    const { say } = transportOf({ openOurs });
    await say(hello());
    await say(run);
    arrive({ receive: (message) => void heard.push(message), close: () => undefined });
    await Promise.resolve();
    await Promise.resolve();
    expect(heard).toEqual([hello(), run]);
  });
});
