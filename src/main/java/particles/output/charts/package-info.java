/**
 * Charts by JFreeChart, all in one style.
 */
package particles.output.charts;
