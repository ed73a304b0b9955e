// A uPlot chart in the page's style, which fills its box and is redrawn when its options, such as the colours, change.
import {useLayoutEffect, useRef} from "preact/hooks";
import uPlot from "uplot";
import {TYPEFACE} from "./canvas";
import type {Palette} from "./colours";

export type PlotOptions = Omit<uPlot.Options, "width" | "height">;

export interface PlotProps {
  options: PlotOptions;
  data: uPlot.AlignedData;
  label: string;
  onReady?: (plot: uPlot) => void;
}

const FONT = `11px ${TYPEFACE}`;

export function axis(colours: Palette, label: string, more: Partial<uPlot.Axis> = {}): uPlot.Axis {
  return {
    label,
    labelSize: 18,
    labelFont: FONT,
    font: FONT,
    stroke: colours.muted,
    size: more.side === 3 ? 54 : 26,
    gap: 4,
    labelGap: 0,
    grid: {stroke: colours.line, width: 1},
    ticks: {stroke: colours.line, width: 1, size: 4},
    ...more,
  };
}

/** Options of a plot without uPlot's own legend and without a cursor that follows the pointer. */
const LOOK: Partial<uPlot.Options> = {
  padding: [10, 14, 0, 0],
  legend: {show: false},
  cursor: {x: false, y: false, points: {show: false}, drag: {x: false, y: false}},
};

export function Plot({options, data, label, onReady}: PlotProps) {
  const box = useRef<HTMLDivElement>(null);
  // A layout effect draws synchronously, so that a print has the print colours.
  useLayoutEffect(() => {
    const element = box.current!;
    const size = () => ({width: Math.max(80, element.clientWidth), height: Math.max(60, element.clientHeight)});
    const plot = new uPlot({...LOOK, ...options, ...size()}, data, element);
    onReady?.(plot);
    const observer = new ResizeObserver(() => {
      const {width, height} = size();
      if (width !== plot.width || height !== plot.height) plot.setSize({width, height});
    });
    observer.observe(element);
    return () => {
      observer.disconnect();
      plot.destroy();
    };
  }, [options, data]);
  return <div class="plot" ref={box} role="img" aria-label={label} />;
}
