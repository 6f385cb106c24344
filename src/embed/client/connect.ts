import { isFrame, openChannel, type Target } from './channel';
import { Connection } from './connection';
import { ParcoursError } from './parcours-error';
import type { OfDevice } from '../parcours/protocol';
import type { Commands, ConnectOptions, Parcours, Welcome } from './types';

export type { Target } from './channel';
export { ParcoursError } from './parcours-error';
export type * from './types';

/**
 * Connects with a simulator in a frame, a window or behind a port; the page may still be loading.
 *
 * @returns the simulator, once the page has answered
 * @throws ParcoursError (as a rejection) with `timeout` if it does not
 */
export async function connect(target: Target, options: ConnectOptions = {}): Promise<Parcours> {
  const channel = openChannel(target, options.origin, options.usePort ?? false, (data) => connection.hear(data));
  const connection = new Connection(channel, options);
  const stopWatching = watchFrame(target, connection);
  try {
    await connection.greet();
  } catch (error) {
    stopWatching();
    connection.close();
    throw error;
  }
  return parcoursOf(connection, stopWatching);
}

/** A `load` event of the frame may mean that it was loaded anew. */
function watchFrame(target: Target, connection: Connection): () => void {
  if (!isFrame(target)) return () => undefined;
  const greetAgain = (): void => connection.greetAgain();
  target.addEventListener('load', greetAgain);
  return () => target.removeEventListener('load', greetAgain);
}

function parcoursOf(connection: Connection, stopWatching: () => void): Parcours {
  const send: Connection['send'] = (type, fields) => connection.send(type, fields);
  const done = async (...[type, fields]: Parameters<Connection['send']>): Promise<void> => {
    await send(type, fields);
  };
  return {
    get welcome(): Welcome {
      if (connection.welcome === null) throw new ParcoursError('closed', 'The page has not answered.');
      return connection.welcome;
    },
    ...workMethods(send, done),
    ...runMethods(done),
    ...debugMethods(send, done),
    ...inputMethods(done),
    getState: () => send('state', {}),
    subscribe: (wish) => done('subscribe', wish),
    on: (event, listener) => connection.on(event, listener),
    send: (type, ...[fields]) => connection.send(type, fields ?? {}),
    close() {
      stopWatching();
      connection.close();
    },
  };
}

type Done = (...[type, fields]: Parameters<Connection['send']>) => Promise<void>;

function workMethods(send: Connection['send'], done: Done) {
  return {
    setProject: (project) => done('set-project', { project }),
    getProject: async () => (await send('get-project', {})).project,
    setFiles: (files, device) => done('set-files', { files, ...of(device) }),
    getFiles: async (device) => (await send('get-files', of(device))).files,
    setScene: (scene) => done('set-scene', { scene }),
    getScene: async () => (await send('get-scene', {})).scene,
    edit: (edit) => done('edit', { edit }),
    setRobot: (choice) => done('set-robot', choice),
    getRobot: () => send('get-robot', {}),
    setSettings: (settings) => done('settings', settings),
    setMode: (mode) => done('set-mode', { mode }),
    getSettings: () => send('get-settings', {}),
  } satisfies Partial<Parcours>;
}

function runMethods(done: Done) {
  return {
    run: (options: Commands['run']['fields'] = {}) => done('run', options),
    stop: () => done('stop', {}),
    reset: () => done('reset', {}),
    pause: () => done('pause', {}),
    resume: () => done('resume', {}),
    step: () => done('step', {}),
    setSpeed: (speed) => done('speed', { speed }),
    setSeed: (seed) => done('seed', { seed }),
    setReality: (reality) => done('reality', { reality }),
  } satisfies Partial<Parcours>;
}

function debugMethods(send: Connection['send'], done: Done) {
  return {
    getPosition: (device) => send('get-position', of(device)),
    setBreakPoints: (points, device) => done('set-break-points', { points, ...of(device) }),
    getBreakPoints: async (device) => (await send('get-break-points', of(device))).points,
    stepLine: (step, device) => done('step-line', { step, ...of(device) }),
    runTo: ({ file, line }, device) => done('run-to', { file, line, ...of(device) }),
    lookAt: (atMs) => done('look-at', { atMs }),
    lookNow: () => done('look-now', {}),
    goOn: (options: Commands['go-on']['fields'] = {}) => done('go-on', options),
  } satisfies Partial<Parcours>;
}

/** The field that names a microcomputer; none for the first, or all. */
const of = (device: string | undefined): OfDevice => (device === undefined ? {} : { device });

function inputMethods(done: Done) {
  return {
    place: (pose, device) => done('place', { ...pose, ...of(device) }),
    placeBlock: (block, pose) => done('place-block', { block, ...pose }),
    press: (button, down, device) => done('press', { button, down, ...of(device) }),
    touch: (pad, down, device) => done('touch', { pad, down, ...of(device) }),
    setSensor: (sensor, value, device) => done('sensor', { sensor, value, ...of(device) }),
    setArenaSenses: (on) => done('arena-senses', { on }),
    serial: (text, device) => done('serial', { text, ...of(device) }),
    interrupt: (device) => done('interrupt', of(device)),
    radio: (packet, device) =>
      done('radio', { ...(typeof packet === 'string' ? { text: packet } : { bytes: [...packet] }), ...of(device) }),
    clearConsole: () => done('clear-console', {}),
  } satisfies Partial<Parcours>;
}
