import { shallowRef } from 'vue';

import { cleanFirmware } from '#hex/clean';
import type { Firmware, HexBoard, HexProblem } from '#hex/firmware';
import { limits } from '#intake/formats';

import { lateModel } from '../../../kit/state/late-models';
import { hostFirmwares, hostHex, type Fetch, type HostFirmware } from './host-firmware';
import { keepFirmwares, keptFirmwares, removeFirmware, type KeptFirmware } from './kept-firmware';

/** The outcome of giving a file. */
export type Taken =
  | { readonly kind: 'taken'; readonly boards: readonly HexBoard[]; readonly isKept: boolean }
  | { readonly kind: 'refused'; readonly problem: HexProblem | { readonly code: 'size' } };

/** The MicroPython of boards: kept in this browser, offered by the page's web server, or given by somebody. */
export class FirmwareModel {
  /** Those at hand, by board. */
  readonly all = shallowRef<ReadonlyMap<HexBoard, KeptFirmware>>(new Map());
  /** True until it is known what is at hand. */
  readonly isLooking = shallowRef(true);
  private offered: readonly HostFirmware[] | null = null;

  /** @param get fetches from the page's web server; `null`: there is none, as in a page of a single file */
  constructor(private readonly get: Fetch | null) {}

  of(board: HexBoard): Firmware | null {
    return this.all.value.get(board)?.firmware ?? null;
  }

  /** Looks for the firmware of a board, here and on the web server. What somebody has given stays. */
  async look(board: HexBoard): Promise<void> {
    this.isLooking.value = true;
    if (this.all.value.size === 0) this.add(await keptFirmwares());
    const has = this.all.value.get(board);
    if (has === undefined || has.sum !== null) await this.askHost(board, has?.sum ?? null);
    this.isLooking.value = false;
  }

  /** Takes the firmware out of a hex of somebody's own. */
  async take(file: Blob): Promise<Taken> {
    if (file.size > limits.hex) return { kind: 'refused', problem: { code: 'size' } };
    const cleaned = cleanFirmware(await file.text());
    if ('problem' in cleaned) return { kind: 'refused', problem: cleaned.problem };
    const isKept = await this.keep(cleaned.firmwares, null);
    return { kind: 'taken', boards: cleaned.firmwares.map(({ board }) => board), isKept };
  }

  /** Removes the firmware of a board, so that another one can be given. */
  async remove(board: HexBoard): Promise<void> {
    this.all.value = new Map([...this.all.value].filter(([name]) => name !== board));
    await removeFirmware(board);
  }

  private async askHost(board: HexBoard, sum: string | null): Promise<void> {
    if (this.get === null) return;
    this.offered ??= await hostFirmwares(this.get);
    const offer = this.offered.find((it) => it.board === board);
    if (offer === undefined || offer.sha256.toLowerCase() === sum) return;
    const text = await hostHex(offer, this.get);
    const cleaned = text === null ? null : cleanFirmware(text);
    if (cleaned === null || 'problem' in cleaned) return;
    const missing = cleaned.firmwares.filter((it) => it.board === board || !this.all.value.has(it.board));
    await this.keep(missing, offer.sha256.toLowerCase());
  }

  private keep(firmwares: readonly Firmware[], sum: string | null): Promise<boolean> {
    const list = firmwares.map((firmware) => ({ name: firmware.board, firmware, sum }));
    this.add(list);
    return keepFirmwares(list);
  }

  private add(list: readonly KeptFirmware[]): void {
    this.all.value = new Map([...this.all.value, ...list.map((kept) => [kept.name, kept] as const)]);
  }
}

/** The firmwares of this page. */
export const firmwareModel = lateModel(() => {
  const isServed = /^https?:$/.test(location.protocol) && globalThis.origin !== 'null';
  return new FirmwareModel(isServed ? (address, how) => fetch(address, how) : null);
});
