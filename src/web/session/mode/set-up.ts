import { useModeKeys } from './mode-keys';

/** Enters modes by keys. */
export const setUp = useModeKeys;
