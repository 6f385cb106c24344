import { describe, expect, it } from 'vitest';
import { Clock } from '#core/clock';
import { askedSensors } from './asked-sensors';
import { Board } from '../board';
import { boardTypes } from '../boards/index';
import { WIDEST_G } from './motion';

describe.each(boardTypes)('the sensors of a $name that is not there', (type) => {
  it('are those of the board whose program has set the accelerometer to 8 g, in the same order and ranges', () => {
    const board = new Board(type, new Clock());
    board.motion.setRange(WIDEST_G);
    expect(askedSensors(type).describe()).toEqual(board.sensors.describe());
  });
});
