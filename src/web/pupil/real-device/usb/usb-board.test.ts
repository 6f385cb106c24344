import { afterEach, describe, expect, it, vi } from 'vitest';

import { hexText } from '#hex/testing/firmware';
import { FakeBoard, type FakeStart } from './testing/fake-board';
import { UsbBoard, type UsbProgress } from './usb-board';
import { HexError, type BoardVersion } from './usb-problem';

const PAGES = 6;

/** A board at this computer's USB. */
function plugged(start: FakeStart = {}): FakeBoard {
  const fake = new FakeBoard(start);
  vi.stubGlobal('navigator', { usb: fake.usb });
  return fake;
}
/** A hex of a small firmware; its last page has the program. */
function hexOf(program: string): string {
  const bytes = new Uint8Array(4096 * PAGES).fill(0x55);
  bytes.set(new TextEncoder().encode(program), bytes.length - 4096);
  return hexText([{ address: 0, bytes }]);
}
const programOn = ({ flash }: FakeBoard, letters: number): string =>
  new TextDecoder().decode(flash.subarray(4096 * (PAGES - 1), 4096 * (PAGES - 1) + letters));

/** Puts a hex on the board, and collects what is told meanwhile. */
async function put(
  board: UsbBoard,
  hex: string | ((version: BoardVersion) => Promise<string>),
  told: UsbProgress[] = [],
) {
  const end = await board.put(typeof hex === 'string' ? () => Promise.resolve(hex) : hex, (progress) =>
    told.push(progress),
  );
  return { end, stages: [...new Set(told.map(({ stage }) => stage))], told };
}

afterEach(() => vi.unstubAllGlobals());

describe('a program on its way over USB', { timeout: 30_000 }, () => {
  it('goes over as a whole onto a board with something else, after the browser has asked which one', async () => {
    const fake = plugged();
    const board = new UsbBoard();
    const { end, stages, told } = await put(board, hexOf('one'));
    expect(end).toEqual({ kind: 'done', extent: 'full', version: 'V2' });
    expect(stages).toEqual(['choosing', 'connecting', 'sending', 'starting']);
    expect(told.map(({ part }) => part)).toEqual(told.map(({ part }) => part).sort((a, b) => a - b));
    expect(programOn(fake, 3)).toBe('one');
    expect([fake.done.full, fake.done.asked, board.state.value]).toEqual([1, 1, 'connected']);
  });

  it('goes over in part when little is different, and not at all when nothing is; nobody is asked again', async () => {
    const fake = plugged();
    const board = new UsbBoard();
    await put(board, hexOf('one'));
    expect((await put(board, hexOf('two'))).end).toMatchObject({ kind: 'done', extent: 'partial' });
    expect([programOn(fake, 3), fake.done.pages]).toEqual(['two', 1]);
    const resets = fake.done.resets;
    expect((await put(board, hexOf('two'))).end).toMatchObject({ kind: 'done', extent: 'unchanged' });
    expect([fake.done.pages, fake.done.full, fake.done.asked]).toEqual([1, 1, 1]);
    expect(fake.done.resets).toBeGreaterThan(resets); // the program starts all the same
  });

  it('asks nobody where the browser has been allowed to use the board earlier', async () => {
    const fake = plugged({ isAllowed: true });
    const { end } = await put(new UsbBoard(), hexOf('one'));
    expect([end.kind, fake.done.asked]).toEqual(['done', 0]);
  });

  it('is made for the version of the board that is there', async () => {
    plugged({ boardId: '9901', pageBytes: 1024, pages: 256 });
    const asked: BoardVersion[] = [];
    const { end } = await put(new UsbBoard(), (version) => {
      asked.push(version);
      return Promise.resolve(hexOf('one'));
    });
    expect([asked, end]).toEqual([['V1'], { kind: 'done', extent: 'full', version: 'V1' }]);
  });

  it('does not begin when its hex cannot be made; the board stays connected', async () => {
    const fake = plugged();
    const board = new UsbBoard();
    const problem = { kind: 'other-board', found: 'microbit-v1' } as const;
    const { end } = await put(board, () => Promise.reject(new HexError(problem)));
    expect([end, board.state.value, fake.done.full]).toEqual([{ kind: 'problem', problem }, 'connected', 0]);
  });
});

describe('a transfer over USB that does not succeed', { timeout: 30_000 }, () => {
  it.each<readonly [string, FakeStart, object]>([
    ['nothing was chosen', { refusal: 'nothing-chosen' }, { kind: 'nothing' }],
    ['the frame or the school forbids it', { refusal: 'forbidden' }, { kind: 'problem', problem: { kind: 'frame' } }],
    ['a second tab has the board', { isTaken: true }, { kind: 'problem', problem: { kind: 'in-use' } }],
    ['it is another board', { boardId: '1234' }, { kind: 'problem', problem: { kind: 'not-a-board' } }],
    ['its interface is too old', { isOld: true }, { kind: 'problem', problem: { kind: 'old-interface' } }],
  ])('says why: %s', async (_, start, expected) => {
    plugged(start);
    expect((await put(new UsbBoard(), hexOf('one'))).end).toEqual(expected);
  });

  it('says that the cable came out, before anything and in the middle; afterwards it goes on from the beginning', async () => {
    plugged({ unplugsAt: 6 });
    const before = await put(new UsbBoard(), hexOf('one'));
    expect(before.end).toEqual({ kind: 'problem', problem: { kind: 'unplugged', isTouched: false } });
    plugged({ unplugsAt: 2500 });
    const board = new UsbBoard();
    const { end, told } = await put(board, hexOf('one'));
    expect(told.at(-1)?.stage).toBe('sending');
    expect([end, board.state.value]).toEqual([{ kind: 'problem', problem: { kind: 'unplugged', isTouched: true } }, 'gone']); // prettier-ignore
    plugged();
    expect((await put(board, hexOf('one'))).end).toMatchObject({ kind: 'done', extent: 'full' });
  });

  it('can be stopped in the middle: nothing more is sent, the board stays connected, and the next transfer makes it whole', async () => {
    const fake = plugged();
    const board = new UsbBoard();
    const end = await board.put(() => Promise.resolve(hexOf('one')), ({ part }) => part > 0.2 && board.stop()); // prettier-ignore
    expect(end).toEqual({ kind: 'problem', problem: { kind: 'stopped' } });
    expect([fake.done.pages, board.state.value]).toEqual([0, 'connected']);
    expect(programOn(fake, 3)).not.toBe('one');
    expect((await put(board, hexOf('one'))).end.kind).toBe('done');
    expect(programOn(fake, 3)).toBe('one');
  });

  it('can be stopped while just the differences are sent', async () => {
    const fake = plugged();
    const board = new UsbBoard();
    await put(board, hexOf('one'));
    const end = await board.put(
      () => Promise.resolve(hexOf('two')),
      ({ stage }) => stage === 'sending' && board.stop(),
    );
    expect(end).toEqual({ kind: 'problem', problem: { kind: 'stopped' } });
    expect(board.state.value).toBe('connected');
    expect(programOn(fake, 3)).not.toBe('two');
  });

  it('has changed nothing on the board when it is stopped before', async () => {
    const fake = plugged();
    const board = new UsbBoard();
    const end = await board.put(
      () => Promise.resolve(hexOf('one')),
      ({ stage }) => stage === 'connecting' && board.stop(),
    );
    expect([end, fake.done.full, fake.done.pages]).toEqual([{ kind: 'nothing' }, 0, 0]);
  });

  it('lets go of the board when the page is done with it meanwhile', async () => {
    const fake = plugged();
    const board = new UsbBoard();
    const one = () => Promise.resolve(hexOf('one'));
    const end = await board.put(one, ({ part }) => void (part > 0.2 && board.disconnect()));
    expect(end).toEqual({ kind: 'problem', problem: { kind: 'stopped' } });
    await vi.waitFor(() => expect([fake.isOpen, board.state.value]).toEqual([false, 'gone']));
    expect(fake.done.pages).toBe(0);
  });
});

describe('a board that stays connected', { timeout: 30_000 }, () => {
  it('tells what its program says from the start on, and takes text', async () => {
    const fake = plugged({ says: 'hello\r\n' });
    const board = new UsbBoard();
    await put(board, hexOf('one'));
    const said = () => board.output.map(({ text }) => text).join('');
    await vi.waitFor(() => expect(said()).toBe('hello\r\n'));
    board.send('x'.repeat(70));
    await vi.waitFor(() => expect(fake.heard).toBe('x'.repeat(70)));
    await put(board, hexOf('two'));
    await vi.waitFor(() => expect([said(), board.start.value]).toEqual(['hello\r\n', 2]));
    fake.unplug();
    expect([board.state.value, said()]).toEqual(['gone', 'hello\r\n']);
  });

  it('is let go when that is wished', async () => {
    plugged();
    const ended = vi.fn();
    const board = new UsbBoard(ended);
    await put(board, hexOf('one'));
    await board.disconnect();
    expect(ended).toHaveBeenCalledOnce();
    await vi.waitFor(() => expect(board.state.value).toBe('gone'));
  });
});
