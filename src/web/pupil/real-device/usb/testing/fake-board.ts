/** The beginning of a fake board. */
export interface FakeStart {
  /** The first four digits of the number that its interface chip tells. Left out: a micro:bit V2. */
  readonly boardId?: string;
  readonly pageBytes?: number;
  readonly pages?: number;
  /** True if another tab or program holds it. */
  readonly isTaken?: boolean;
  /** True for an interface firmware without CMSIS-DAP by WebUSB. */
  readonly isOld?: boolean;
  /** The cable comes out before the transfer with this number. */
  readonly unplugsAt?: number;
  /** A program says this after each start. */
  readonly says?: string;
  /** True if the browser has been allowed to use it earlier. */
  readonly isAllowed?: boolean;
  /** The chooser's answer, in place of the board. */
  readonly refusal?: 'nothing-chosen' | 'forbidden';
}

/**
 * A board at the other end of the browser's USB: its interface chip (CMSIS-DAP, DAPLink's own commands) and of its
 * processor just memory, debug registers and the two programs that the flasher runs in RAM. It refers to nothing outside
 * itself, since browser tests hand its source to the page.
 */
export class FakeBoard {
  readonly flash: Uint8Array<ArrayBuffer>;
  /** Words beside flash and RAM, by address. */
  readonly words = new Map<number, number>();
  /** Counts of what the flasher did. */
  readonly done = { asked: 0, transfers: 0, full: 0, pages: 0, resets: 0 };
  /** Text that the page has sent. */
  heard = '';
  /** True while the page holds it. */
  isOpen = false;
  private readonly start: Required<FakeStart>;
  private readonly ram = new Uint8Array(0x20000);
  private readonly core: number[] = new Array<number>(32).fill(0);
  private readonly listeners = new Set<(event: unknown) => void>();
  private readonly serial: number[] = [];
  private readonly device: Readonly<Record<string, unknown>>;
  private pieces: Uint8Array[] = [];
  private reply = new Uint8Array(64);
  private tar = 0;
  private isHalted = false;
  private isOut = false;

  constructor(start: FakeStart = {}) {
    this.start = {
      ...{ boardId: '9904', pageBytes: 4096, pages: 128, isTaken: false, isOld: false, unplugsAt: Infinity, says: '' },
      ...{ isAllowed: false, refusal: 'none' as never },
      ...start,
    };
    const { pageBytes, pages } = this.start;
    this.flash = new Uint8Array(pageBytes * pages); // everything on it is something else
    this.words.set(0x10000010, pageBytes).set(0x10000014, pages).set(0x10000064, 4711);
    this.device = this.makeDevice();
  }

  /** The browser's `navigator.usb`, with this board as all there is. */
  readonly usb = {
    getDevices: () => Promise.resolve(this.start.isAllowed && !this.isOut ? [this.device] : []),
    requestDevice: () => {
      this.done.asked += 1;
      const { refusal } = this.start;
      if (refusal === 'nothing-chosen') return this.fail('No device selected.');
      if (refusal === 'forbidden') return this.fail('Access to the feature "usb" is disallowed by permissions policy.');
      return Promise.resolve(this.device);
    },
    addEventListener: (type: string, act: (event: unknown) => void) => type === 'disconnect' && this.listeners.add(act),
    removeEventListener: (_: string, act: (event: unknown) => void) => this.listeners.delete(act),
  };

  /** Pulls the cable. */
  unplug(): void {
    this.isOut = true;
    for (const act of this.listeners) act({ device: this.device });
  }

  /** The program on it says something. */
  say(text: string): void {
    this.serial.push(...new TextEncoder().encode(text));
  }

  private makeDevice(): Readonly<Record<string, unknown>> {
    const endpoints = [{ direction: 'in', endpointNumber: 1 }, { direction: 'out', endpointNumber: 2 }]; // prettier-ignore
    const alternates = [{ interfaceClass: this.start.isOld ? 3 : 0xff, endpoints }];
    const done = (_?: boolean): Promise<void> => Promise.resolve();
    return {
      ...{ vendorId: 0x0d28, productId: 0x0204, opened: true, productName: 'BBC micro:bit CMSIS-DAP' },
      configuration: { interfaces: [{ interfaceNumber: 4, alternates }] },
      ...{
        open: () => done((this.isOpen = true)),
        close: () => done((this.isOpen = false)),
        selectConfiguration: done,
      },
      claimInterface: () => (this.start.isTaken ? this.fail('Unable to claim interface.') : done()),
      transferOut: async (_: number, packet: Uint8Array<ArrayBuffer>) => {
        await this.transfer();
        this.reply = new Uint8Array(64);
        this.reply[0] = packet[0] ?? 0;
        this.command(packet, new DataView(packet.buffer), new DataView(this.reply.buffer));
      },
      transferIn: async () => {
        await this.transfer();
        return { status: 'ok', data: new DataView(this.reply.buffer) };
      },
    };
  }

  /** A real board takes its time: now and then others get their turn. */
  private async transfer(): Promise<void> {
    this.done.transfers += 1;
    if (this.done.transfers % 64 === 0) await new Promise((resolve) => setTimeout(resolve));
    if (!this.isOut && this.done.transfers >= this.start.unplugsAt) this.unplug();
    if (this.isOut) await this.fail('The device was disconnected.');
  }

  /** Fails in Chromium's words, by which the library knows what is wrong. */
  private readonly fail = (words: string): Promise<never> => Promise.reject(new Error(words));

  private command(packet: Uint8Array, sent: DataView, reply: DataView): void {
    const [command, length = 0] = packet;
    if (command === 0x02) reply.setUint8(1, 1);
    else if (command === 0x05) this.transfers(packet, sent, reply);
    else if (command === 0x06) this.block(packet, sent, reply);
    else if (command === 0x80)
      this.answer(new TextEncoder().encode(`${this.start.boardId}360200532e8f0000000000000000000000009796990b`));
    else if (command === 0x81) reply.setUint32(1, 115_200, true);
    else if (command === 0x83) this.answer(Uint8Array.from(this.serial.splice(0, 62)));
    else if (command === 0x84) this.heard += new TextDecoder().decode(packet.subarray(2, 2 + length));
    else if (command === 0x8a) this.pieces = [];
    else if (command === 0x8b) this.program();
    else if (command === 0x8c) {
      const piece = packet.slice(2, 2 + length);
      this.pieces.push(piece);
      if (new TextDecoder().decode(piece).includes(':00000001FF')) reply.setUint8(1, 18);
    }
  }

  private answer(bytes: Uint8Array): void {
    this.reply[1] = bytes.length;
    this.reply.set(bytes, 2);
  }

  /** Several reads and writes of registers in one packet. */
  private transfers(packet: Uint8Array, sent: DataView, reply: DataView): void {
    const count = packet[2] ?? 0;
    let at = 3;
    for (let place = 0; place < count; place++) {
      const wish = packet[3 + place * 5] ?? 0;
      if ((wish & 2) === 0) this.setRegister(wish, sent.getUint32(4 + place * 5, true));
      else {
        reply.setUint32(at, this.register(wish), true);
        at += 4;
      }
    }
    reply.setUint8(1, count);
    reply.setUint8(2, 1);
  }

  /** One register many times: a piece of memory. */
  private block(packet: Uint8Array, sent: DataView, reply: DataView): void {
    const count = sent.getUint16(2, true);
    const wish = packet[4] ?? 0;
    for (let place = 0; place < count; place++)
      if ((wish & 2) === 0) this.setRegister(wish, sent.getUint32(5 + place * 4, true));
      else reply.setUint32(4 + place * 4, this.register(wish), true);
    reply.setUint16(1, count, true);
    reply.setUint8(3, 1);
  }

  private register(wish: number): number {
    if ((wish & 1) === 0) return (wish & 12) === 4 ? 0xf0000040 : 0x2ba01477; // the debug port: powered up
    if ((wish & 12) !== 12) return 0;
    this.tar += 4;
    return this.word(this.tar - 4);
  }

  private setRegister(wish: number, value: number): void {
    if ((wish & 1) === 0) return;
    if ((wish & 12) === 4) this.tar = value;
    if ((wish & 12) !== 12) return;
    this.tar += 4;
    this.setWord(this.tar - 4, value);
  }

  private word(address: number): number {
    const { core, isHalted } = this;
    if (address === 0xe000edf0) return (1 << 16) | (isHalted ? 1 << 17 : 0); // DHCSR: a register is ready, the core halts
    if (address === 0xe000edf8) return core[31] ?? 0; // DCRDR
    if (address === 0x40002120 || address === 0x40002158 || address === 0x4001e400) return 1; // UARTE and NVMC have ended
    const [memory, from] = this.memoryAt(address);
    if (memory !== null) return new DataView(memory.buffer).getUint32(address - from, true);
    return this.words.get(address) ?? (address >>> 12 === 0x10001 ? 0xffffffff : 0);
  }

  private setWord(address: number, value: number): void {
    const { core } = this;
    if (address === 0xe000edf0) this.isHalted = (value & 2) !== 0 || this.runInRam();
    else if (address === 0xe000edf8) core[31] = value;
    else if (address === 0xe000edf4 && (value & 0x10000) !== 0) core[value & 31] = core[31] ?? 0;
    else if (address === 0xe000edf4) core[31] = core[value & 31] ?? 0;
    else if (address === 0xe000ed0c && (value & 4) !== 0) this.reset();
    else if (address === 0x40002008) this.serial.push(...new Array<number>(2048).fill(0)); // the flasher fills the line
    const [memory, from] = this.memoryAt(address);
    if (memory === this.ram) new DataView(memory.buffer).setUint32(address - from, value, true);
    else this.words.set(address, value);
  }

  private memoryAt(address: number): readonly [Uint8Array<ArrayBuffer> | null, number] {
    if (address < this.flash.length) return [this.flash, 0];
    return address >= 0x20000000 && address < 0x20020000 ? [this.ram, 0x20000000] : [null, 0];
  }

  /** Does the work of the flasher's programs. @returns true: the core halts again at once */
  private runInRam(): boolean {
    const [first, second] = new Uint32Array(this.ram.buffer, 0, 2);
    const [target = 0, from = 0, words = 0] = this.core;
    if (first === 0x4c27b5f0) this.writeHashes(target - 0x20000000);
    else if (first === 0xbe00be00 && second === 0x2502b5f0) {
      this.flash.set(this.ram.subarray(from - 0x20000000, from - 0x20000000 + words * 4), target);
      this.done.pages += 1;
    } else return false;
    return true;
  }

  /** Two hashes of each page (MurmurHash3), by which the flasher finds what is different. */
  private writeHashes(at: number): void {
    const { pageBytes, pages } = this.start;
    const flash = new Uint32Array(this.flash.buffer);
    const hashes = new DataView(this.ram.buffer);
    for (let page = 0; page < pages; page++) {
      let [one, two] = [0x2f9be6cc, 0x1ec3a6c8];
      for (let place = 0; place < pageBytes / 4; place++) {
        const mixed = Math.imul(flash[(page * pageBytes) / 4 + place] ?? 0, 0xcc9e2d51);
        const key = Math.imul((mixed << 15) | (mixed >>> 17), 0x1b873593);
        one = Math.imul(((one ^ key) << 13) | ((one ^ key) >>> 19), 5) + 0xe6546b64;
        two = Math.imul(((two ^ key) << 13) | ((two ^ key) >>> 19), 5) + 0xe6546b64;
      }
      hashes.setUint32(at + page * 8, one, true);
      hashes.setUint32(at + page * 8 + 4, two, true);
    }
  }

  /** Erases the chip, and takes in the hex that came in pieces. */
  private program(): void {
    if (this.pieces.length === 0) return;
    const decoder = new TextDecoder();
    const lines = this.pieces
      .map((piece) => decoder.decode(piece))
      .join('')
      .split(/\r?\n/);
    this.pieces = [];
    this.flash.fill(0xff);
    let above = 0;
    for (const line of lines) {
      const bytes = Uint8Array.from(line.slice(1).match(/../g) ?? [], (digits) => parseInt(digits, 16));
      const [length = 0, high = 0, low = 0, kind] = bytes;
      const data = bytes.subarray(4, 4 + length);
      if (kind === 2) above = (((data[0] ?? 0) << 8) | (data[1] ?? 0)) * 16;
      else if (kind === 4) above = (((data[0] ?? 0) << 24) | ((data[1] ?? 0) << 16)) >>> 0;
      else if (kind === 0) this.take(above + (high << 8) + low, data);
    }
    this.done.full += 1;
    this.reset();
  }

  private take(address: number, data: Uint8Array): void {
    if (address < this.flash.length) this.flash.set(data, address);
    else
      for (let place = 0; place + 4 <= data.length; place += 4)
        this.words.set(address + place, new DataView(data.buffer, data.byteOffset).getUint32(place, true));
  }

  private reset(): void {
    this.done.resets += 1;
    this.isHalted = ((this.words.get(0xe000edfc) ?? 0) & 1) !== 0; // DEMCR: halt at a reset
    if (!this.isHalted && this.start.says !== '') this.say(this.start.says);
  }
}
