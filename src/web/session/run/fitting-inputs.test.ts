import { describe, expect, it } from 'vitest';

import { Board } from '#board/board';
import { boardTypes } from '#board/boards/index';
import { Clock } from '#core/clock';
import { defaultScene } from '#scene/scene';
import type { InputEvent } from '#simulation/input';
import { fitRun } from '#simulation/run-problem';
import { soloRun, type RunSetup } from '#simulation/run-setup';

import { fittingInputs } from './fitting-inputs';
import { SensorsModel } from './sensors-model';

function setupFor(board: string, inputs: readonly InputEvent[]): RunSetup {
  return soloRun({
    scene: defaultScene(),
    files: { 'main.py': '' },
    robot: 'none',
    board,
    seed: 1,
    reality: 0,
    inputs,
  });
}

describe('what holds for every run', () => {
  it('starts a run on every board, also what was set for another one or in a wider range', () => {
    const sensors = new SensorsModel({ input: () => true, device: 0 });
    for (const id of ['pin3', 'pinLogo', 'buttonA', 'lightLevel']) sensors.set(id, 1);
    sensors.set('accelerometerX', 7000); // in a run that had set the range to 8 g
    for (const type of boardTypes) {
      const inputs = fittingInputs(sensors.startInputs(), type);
      expect(fitRun(setupFor(type.id, inputs)), type.id).not.toHaveProperty('problem');
    }
    expect(fitRun(setupFor('microbit-v2', sensors.startInputs()))).toHaveProperty('problem');
  });

  it('is all of it where the board has everything', () => {
    for (const type of boardTypes) {
      const sensors = new SensorsModel({ input: () => true, device: 0 });
      const infos = new Board(type, new Clock()).sensors.describe();
      for (const info of infos) if (info.kind === 'range') sensors.set(info.id, info.start);
      expect(fittingInputs(sensors.startInputs(), type)).toEqual(sensors.startInputs());
    }
  });
});
