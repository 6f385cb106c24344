import type { ReferenceModule } from '../types';
import { builtins } from './builtins';
import { antigravity, log, love, machine, power, radio, zen } from './exchange';
import { calliopemini, calliopeMini, microbit } from './microbit';
import { audio, music, neopixel, speech } from './sound';
import { array, collections, errno, gc, math, micropython, os, random, struct, sys, time } from './standard';

/** Every module of both boards, the ones that lessons use first. */
export const boardModules: readonly ReferenceModule[] = [
  microbit,
  calliopemini,
  calliopeMini,
  music,
  audio,
  speech,
  radio,
  log,
  neopixel,
  random,
  time,
  math,
  machine,
  power,
  os,
  sys,
  gc,
  micropython,
  struct,
  array,
  collections,
  errno,
  love,
  antigravity,
  zen,
  builtins,
];
