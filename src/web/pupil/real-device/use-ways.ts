import { computed, onMounted, shallowRef, watch } from 'vue';

import { plainFileName } from '#core/plain-file-name';
import { MAIN } from '#project/project';
import { filesForDevice } from '#hex/device-files';
import { fittingFiles } from '#hex/fitting-files';
import type { HexBoard } from '#hex/firmware';

import { usePage } from '../../kit/parts';
import { useHardware } from '../../session/work/hardware/use-hardware';
import { useWork } from '../../session/work/model/parts';
import { fileName } from '../../session/work/save-file';
import { nameToSave } from '../../session/work/work-name';
import { realBoardOf } from './board/boards';
import { firmwareModel } from './firmware/firmware-model';
import type { BoardProgram, Firmwares } from './usb/board-hex';
import { abilityOf, platformOf } from './ways/browser-facts';
import { lastWay } from './ways/last-way';
import { offeredWays, type OfferedWay } from './ways/ways';

/** A program for the device instead of the project. */
export interface OtherProgram {
  readonly text: string;
  /** Id of the robot that it drives. */
  readonly robot: string;
  /** Name of the file in which it is saved. */
  readonly name: string;
}

/** The ways onto a real board for the project, or for another program. */
export function useWays(other: OtherProgram | null) {
  const app = { ...usePage(), ...useWork() };
  const hardware = useHardware(app);
  const firmware = firmwareModel(app);
  const board = shallowRef<HexBoard>(realBoardOf(hardware.value?.board.id));
  const firmwares: Firmwares = (of) => firmware.of(of);
  const program = computed((): BoardProgram =>
    other === null
      ? { own: app.work.files.value, robot: hardware.value?.robot?.id ?? null }
      : { own: [{ name: MAIN, text: other.text }], robot: other.robot },
  );
  const needed = computed(() => filesForDevice(program.value.own, program.value.robot));
  /** Names of the libraries that go over without comments, since they would not fit otherwise. */
  const smaller = computed(() => {
    const room = firmware.of(board.value)?.roomBytes;
    return room === undefined ? [] : fittingFiles(program.value.own, program.value.robot, room).smaller;
  });
  const platform = platformOf(navigator);
  const last = lastWay();
  const ways = computed(() =>
    offeredWays({
      ...{ platform, last, board: board.value, hasFirmware: firmware.of(board.value) !== null },
      ...{ usb: abilityOf('usb'), serial: abilityOf('serial') },
    }),
  );
  const isKnown = shallowRef(false);
  const chosen = shallowRef<OfferedWay['way'] | null>(null);
  /** The way that is open: the chosen one, else the first. */
  const open = computed(() => {
    const able = ways.value.filter(({ hindrance }) => hindrance === null).map(({ way }) => way);
    return able.find((way) => way === chosen.value) ?? able[0] ?? null;
  });
  async function look(): Promise<void> {
    await firmware.look(board.value);
    isKnown.value = true;
  }
  onMounted(look);
  watch(board, () => {
    chosen.value = null;
    void look();
  });
  const base = (): string => other?.name ?? nameToSave(app);
  return {
    ...{ board, firmware, firmwares, program, needed, smaller, platform, ways, open, last, isKnown },
    choose: (way: OfferedWay['way']): void => void (chosen.value = way),
    /** Names of the files to save: the hex's is short and of plain letters, since apps on tablets take it. */
    hexName: (): string => fileName(plainFileName(base(), 24), 'hex'),
    zipName: (): string => fileName(base(), 'zip'),
  };
}
