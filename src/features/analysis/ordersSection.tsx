/** The three orders of linearization, with their difference as a number. */
import { TableScroll } from '../../ui/kit/tableScroll.tsx';
import type { ControlAnalysis } from '../../core/control/analysis.ts';
import { Section } from '../../ui/kit/controls.tsx';
import { formatScientific, formatShort, THIN } from '../../ui/kit/format.ts';
import { words } from './words.ts';
import { fastestGrowth } from './modes.ts';

/** Entries of A that differ by less than this, relative to the fastest eigenvalue, are the same. */
const SAME = 1e-9;

export function OrdersSection({ analysis: { orders, eigenvalues, point } }: { analysis: ControlAnalysis }) {
  const [growth, frozen] = [fastestGrowth(eigenvalues), fastestGrowth(orders.frozenEigenvalues)];
  const scale = Math.max(1, ...eigenvalues.map(([re, im]) => re * re + im * im));
  const agrees = orders.frozenDifference <= SAME * scale;
  const carried = point.multipliers.filter((x) => Math.abs(x) > 1e-9).map((x) => formatShort(x, 3));
  return (
    <Section title={words.orders} open>
      <TableScroll label={words.orders}>
        <table class="orders" data-testid="orders">
          <thead>
            <tr>
              {words.orderColumns.map((column) => (
                <th key={column} scope="col">
                  {column}
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            <tr>
              <th scope="row">{words.orderNames.a}</th>
              <td class="number">{rate(growth)}</td>
              <td class="number">–</td>
            </tr>
            <tr>
              <th scope="row">{words.orderNames.b}</th>
              <td class="number">{rate(fastestGrowth(orders.linearizeFirstEigenvalues))}</td>
              <td class="number" data-testid="difference-b">
                {formatScientific(orders.difference)}
              </td>
            </tr>
            <tr class={agrees ? undefined : 'wrong'}>
              <th scope="row">{words.orderNames.c}</th>
              <td class="number" data-testid="growth-c">
                {rate(frozen)}
              </td>
              <td class="number" data-testid="difference-c">
                {agrees ? formatScientific(orders.frozenDifference) : formatShort(orders.frozenDifference, 4)}
              </td>
            </tr>
          </tbody>
        </table>
      </TableScroll>
      <p data-testid="orders-line">
        {agrees ? words.frozenAgrees : words.frozenDiffers(rate(frozen), rate(growth), carried.join(` ${words.and} `))}
      </p>
    </Section>
  );
}

const rate = (x: number): string => `${formatShort(x, 4)}${THIN}1/s`;
