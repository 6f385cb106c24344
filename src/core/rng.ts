import { FNV_BASIS, fnvOfText } from './fnv';

/** A stream of reproducible random numbers. */
export interface Rng {
  /** A whole number from 0 to 2³² − 1. */
  u32(): number;
  /** A number from 0 up to, but not including, 1. */
  unit(): number;
  /** An independent stream for one purpose, the same for the same seed and name regardless of earlier draws. */
  fork(name: string): Rng;
}

/**
 * Makes a random stream from a seed. Generator: sfc32 (Chris Doty-Humphrey, PractRand), integer arithmetic only,
 * hence the same in every engine.
 */
export function createRng(seed: number): Rng {
  return streamOf(seed >>> 0, 0);
}

function streamOf(seed: number, salt: number): Rng {
  let a = seed | 0;
  let b = salt | 0;
  let c = 0x9e3779b9 | 0;
  let counter = 1;
  const u32 = (): number => {
    const t = (((a + b) | 0) + counter) | 0;
    counter = (counter + 1) | 0;
    a = b ^ (b >>> 9);
    b = (c + (c << 3)) | 0;
    c = (c << 21) | (c >>> 11);
    c = (c + t) | 0;
    return t >>> 0;
  };
  for (let i = 0; i < 12; i++) u32(); // the author's advice: 12 rounds mix a small seed
  return {
    u32,
    unit: () => u32() / 4294967296,
    fork: (name) => streamOf(seed, hashOf(name, salt)),
  };
}

/** Starts with a salt, so that forks of forks depend on the order of their names. */
const hashOf = (name: string, salt: number): number => fnvOfText(name, FNV_BASIS ^ salt) | 0;
