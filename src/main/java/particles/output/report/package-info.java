/**
 * Results of experiments as pages: Markdown with pictures and tables, and one HTML report.
 */
package particles.output.report;
