import type { SetUp } from '../../session/models/session';
import { useBoardKeys } from './use-board-keys';

export const setUp: SetUp = useBoardKeys;
