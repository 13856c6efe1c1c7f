import { expect, test } from 'vitest';
import { formatPower } from '../../../src/ui/kit/format.ts';

test.each([
  [3e-10, '3·10⁻¹⁰'],
  [-2.4e-9, '\u22122·10⁻⁹'],
  [9.7e-4, '1·10⁻³'],
  [4.2e12, '4·10¹²'],
  [0, '0'],
  [0.04, '0.04'],
  [-3.2, '\u22123'],
  [NaN, '–'],
])('%d is written as people do', (x, said) => expect(formatPower(x)).toBe(said));
