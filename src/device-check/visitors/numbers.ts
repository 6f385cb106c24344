import { textOf } from '#python/tree';
import type { Visitors } from '../context';

/** Digits that a single float keeps: 24 bits are 7.2 decimal digits (IEEE 754). */
const DIGITS = 7;
/** The greatest single float (IEEE 754 binary32). */
const GREATEST = 3.4028235e38;

/** Numbers with a decimal point that the device rounds, or cannot hold. */
export const numberVisitors: Visitors = {
  Number(node, context) {
    const name = textOf(context.file, node);
    if (/^0[xob]/i.test(name) || !/[.e]/i.test(name)) return;
    const text = name.replace(/_/g, '').replace(/j$/i, '');
    if (Number(text) > GREATEST) {
      context.report({ node, rule: 'float-range', name });
      return;
    }
    const [mantissa = ''] = text.toLowerCase().split('e');
    const digits = mantissa.replace('.', '').replace(/^0+/, '').replace(/0+$/, '');
    if (digits.length > DIGITS) context.report({ node, rule: 'float-digits', name });
  },
};
